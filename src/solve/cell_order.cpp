#include "solve/cell_order.h"

#include <algorithm>
#include <cmath>

#include "base/counting_sort.h"
#include "base/narrow.h"
namespace knotfit {
CellOrder::CellOrder(const ParameterizedPoints& points) : dimension_(points.dimension) {
  const Index n = points.size();
  narrow(n);
  // A background grid of about 32 points a cell: points near each other stay near in memory, so
  // that later sorts by knot cell read almost in sequence.
  const int g = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(n) / 32)));
  std::vector<std::int32_t> key(n);
  for (Index k = 0; k < n; ++k) {
    const int a = std::min(g - 1, static_cast<int>(points.u(k) * g));
    const int b = std::min(g - 1, static_cast<int>(points.v(k) * g));
    key[k] = a * g + b;
  }
  counting_sort(key, Index{g} * g, input_);
  u_.resize(n);
  v_.resize(n);
  values_.resize(n * dimension_);
  if (!points.weights.empty()) weights_.resize(n);
  for (Index k = 0; k < n; ++k) {
    const Index i = input_[k];
    u_[k] = points.u(i);
    v_[k] = points.v(i);
    std::copy_n(points.value(i), dimension_, values_.begin() + k * dimension_);
    if (!weights_.empty()) weights_[k] = points.weights[i];
  }
  outer_.resize(n);
  inner_.resize(n);
  cell_.resize(n);
}

void CellOrder::append(const ParameterizedPoints& points, Index first) {
  narrow(points.size());
  for (Index k = first; k < points.size(); ++k) {
    input_.push_back(static_cast<std::int32_t>(k));
    u_.push_back(points.u(k));
    v_.push_back(points.v(k));
    values_.insert(values_.end(), points.value(k), points.value(k) + dimension_);
    if (!weights_.empty()) weights_.push_back(points.weights.empty() ? 1.0 : points.weights[k]);
  }
  outer_.resize(input_.size());
  inner_.resize(input_.size());
  cell_.resize(input_.size());
}

void CellOrder::sort(const Axis& outer, const Axis& inner, bool swapped) {
  const Index n = size(), cells = outer.spans() * inner.spans();
  narrow(cells);
  const std::vector<double>& x = swapped ? v_ : u_;
  const std::vector<double>& y = swapped ? u_ : v_;
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k)
      cell_[k] = static_cast<std::int32_t>(outer.span(x[k]) * inner.spans() + inner.span(y[k]));
  });
  const std::vector<Index> start = counting_sort(cell_, cells, order_);
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      const Index i = order_[k], c = cell_[i];
      outer_[k] = outer.local(c / inner.spans(), x[i]);
      inner_[k] = inner.local(c % inner.spans(), y[i]);
    }
  });
  pieces_.clear();
  piece_start_.assign(cells + 1, 0);
  empty_cells_ = 0;
  for (Index c = 0; c < cells; ++c) {
    piece_start_[c] = static_cast<Index>(pieces_.size());
    for (Index at = start[c]; at < start[c + 1]; at += kChunk)
      pieces_.push_back({c, at, std::min(start[c + 1], at + kChunk)});
    if (start[c] == start[c + 1] && outer.length(c / inner.spans()) > 0 &&
        inner.length(c % inner.spans()) > 0)
      ++empty_cells_;
  }
  piece_start_[cells] = static_cast<Index>(pieces_.size());
}

}  // namespace knotfit
