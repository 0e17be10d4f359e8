#include "solve/cell_order.h"

#include <algorithm>
#include <cmath>

#include "base/narrow.h"
namespace knotfit {
namespace {

constexpr Index kBlocks = 16;  // histograms of a counting sort: fixed, whatever the threads

/// Stable counting sort: position of every item by its key in [0, keys).
std::vector<Index> counting_sort(const std::vector<std::int32_t>& key, Index keys,
                                 std::vector<std::int32_t>& order) {
  const Index n = static_cast<Index>(key.size());
  const Index blocks = std::clamp<Index>(n / kChunk, 1, kBlocks), block = (n + blocks - 1) / blocks;
  std::vector<Index> start(keys + 1, 0);
  std::vector<std::vector<std::int32_t>> count(blocks);
  parallel_chunks(
      n,
      [&](Index b, Index begin, Index end) {
        count[b].assign(keys, 0);
        for (Index k = begin; k < end; ++k) ++count[b][key[k]];
      },
      block);
  Index sum = 0;
  for (Index c = 0; c < keys; ++c) {
    start[c] = sum;
    for (auto& h : count) {
      if (h.empty()) continue;
      const std::int32_t here = h[c];
      h[c] = static_cast<std::int32_t>(sum);
      sum += here;
    }
  }
  start[keys] = sum;
  order.resize(n);
  parallel_chunks(
      n,
      [&](Index b, Index begin, Index end) {
        for (Index k = begin; k < end; ++k) order[count[b][key[k]]++] = static_cast<std::int32_t>(k);
      },
      block);
  return start;
}

}  // namespace

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
