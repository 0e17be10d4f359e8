#include "report/error_field.h"

#include <algorithm>
#include <cmath>

namespace knotfit::report {
namespace {

Index cell_of(double t, Index size) {
  return std::clamp<Index>(static_cast<Index>(std::floor(t * static_cast<double>(size))), 0, size - 1);
}

double squared_distance(Index a, Index b, Index size) {
  const Index i = a / size - b / size, j = a % size - b % size;
  return static_cast<double>(i * i + j * j);
}

// The nearest cell with a value, for every cell, by two sweeps [Danielsson80]; -1 where all are empty.
std::vector<Index> nearest_filled(const std::vector<double>& own, Index size) {
  std::vector<Index> nearest(own.size(), -1);
  for (Index k = 0; k < size * size; ++k)
    if (!std::isnan(own[k])) nearest[k] = k;
  auto take = [&](Index i, Index j, Index from_i, Index from_j) {
    if (from_i < 0 || from_i >= size || from_j < 0 || from_j >= size) return;
    const Index k = i * size + j, other = nearest[from_i * size + from_j];
    if (other < 0) return;
    if (nearest[k] < 0 || squared_distance(k, other, size) < squared_distance(k, nearest[k], size))
      nearest[k] = other;
  };
  for (Index sweep : {1, -1}) {
    for (Index step = 0; step < size; ++step) {
      const Index i = sweep > 0 ? step : size - 1 - step;
      for (Index j = 0; j < size; ++j) {
        for (Index side : {-1, 0, 1}) take(i, j, i - sweep, j + side);
        take(i, j, i, j - 1);
      }
      for (Index j = size - 1; j >= 0; --j) take(i, j, i, j + 1);
    }
  }
  return nearest;
}

}  // namespace

ErrorField::ErrorField(const ParameterizedPoints& points, const std::vector<double>& errors,
                       const Domain& domain)
    : domain_(domain) {
  const Index n = points.size();
  if (n == 0 || errors.empty()) return;
  // Some three cells a mean distance of points, where that is not finer than a page shows.
  const double across = std::sqrt(static_cast<double>(n));
  size_ = std::clamp<Index>(static_cast<Index>(3 * across), 48, 600);
  std::vector<double> own(static_cast<std::size_t>(size_ * size_), NAN);
  for (Index k = 0; k < n; ++k) {
    double& cell = own[cell_of(domain.to_unit_u(points.u(k)), size_) * size_ +
                       cell_of(domain.to_unit_v(points.v(k)), size_)];
    if (std::isnan(cell) || std::abs(errors[k]) > std::abs(cell)) cell = errors[k];
  }
  const double reach = std::max(3.0, 4 * static_cast<double>(size_) / across);
  const std::vector<Index> nearest = nearest_filled(own, size_);
  value_.assign(own.size(), NAN);
  for (Index k = 0; k < size_ * size_; ++k)
    if (const Index from = nearest[k]; from >= 0 && squared_distance(k, from, size_) <= reach * reach)
      value_[k] = own[from];
}

std::optional<double> ErrorField::at(double u, double v) const {
  if (empty()) return std::nullopt;
  const double last = static_cast<double>(size_ - 1);
  const double x = std::clamp(domain_.to_unit_u(u) * static_cast<double>(size_) - 0.5, 0.0, last);
  const double y = std::clamp(domain_.to_unit_v(v) * static_cast<double>(size_) - 0.5, 0.0, last);
  const Index i = std::min(static_cast<Index>(x), size_ - 2), j = std::min(static_cast<Index>(y), size_ - 2);
  const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
  double sum = 0, weight = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      const double w = (a ? fx : 1 - fx) * (b ? fy : 1 - fy);
      const double value = value_[(i + a) * size_ + j + b];
      if (std::isnan(value)) continue;
      sum += w * value;
      weight += w;
    }
  if (weight < 0.5) return std::nullopt;
  return sum / weight;
}

ThinField::ThinField(const std::vector<ThinPlace>& places, const Domain& domain) : domain_(domain) {
  if (places.empty()) return;
  distance_.assign(static_cast<std::size_t>(kSize * kSize), 2.0);
  const double step = 1.0 / static_cast<double>(kSize - 1);
  const Index reach = static_cast<Index>(std::ceil(2 * kRadius / step));
  for (const ThinPlace& p : places) {
    const double x = domain.to_unit_u(p.u), y = domain.to_unit_v(p.v);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const Index ci = cell_of(x, kSize), cj = cell_of(y, kSize);
    for (Index i = std::max<Index>(0, ci - reach); i <= std::min(kSize - 1, ci + reach); ++i)
      for (Index j = std::max<Index>(0, cj - reach); j <= std::min(kSize - 1, cj + reach); ++j) {
        double& d = distance_[static_cast<std::size_t>(i * kSize + j)];
        d = std::min(
            d, std::hypot(static_cast<double>(i) * step - x, static_cast<double>(j) * step - y) / kRadius);
      }
  }
}

double ThinField::ratio(double u, double v) const {
  if (empty()) return 2;
  const double last = static_cast<double>(kSize - 1);
  const double x = std::clamp(domain_.to_unit_u(u), 0.0, 1.0) * last;
  const double y = std::clamp(domain_.to_unit_v(v), 0.0, 1.0) * last;
  const Index i = std::min(static_cast<Index>(x), kSize - 2), j = std::min(static_cast<Index>(y), kSize - 2);
  const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
  return (1 - fx) * ((1 - fy) * at(i, j) + fy * at(i, j + 1)) +
         fx * ((1 - fy) * at(i + 1, j) + fy * at(i + 1, j + 1));
}

std::vector<Vec2> ThinField::outline() const {
  std::vector<Vec2> ends;
  if (empty()) return ends;
  const double step = 1.0 / static_cast<double>(kSize - 1);
  // Marching squares, each cell as two triangles: no ambiguous case.
  auto triangle = [&](const Index(&i)[3], const Index(&j)[3]) {
    Vec2 cut[2];
    int cuts = 0;
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      const double fa = at(i[a], j[a]) - 1, fb = at(i[b], j[b]) - 1;
      if ((fa < 0) == (fb < 0) || cuts == 2) continue;
      const double t = fa / (fa - fb);
      cut[cuts++] = {step * (static_cast<double>(i[a]) + t * static_cast<double>(i[b] - i[a])),
                     step * (static_cast<double>(j[a]) + t * static_cast<double>(j[b] - j[a]))};
    }
    if (cuts == 2) ends.insert(ends.end(), {cut[0], cut[1]});
  };
  for (Index i = 0; i + 1 < kSize; ++i)
    for (Index j = 0; j + 1 < kSize; ++j) {
      triangle({i, i + 1, i + 1}, {j, j, j + 1});
      triangle({i, i + 1, i}, {j, j + 1, j + 1});
    }
  return ends;
}

OpeningField::OpeningField(const std::vector<std::array<double, 6>>& triangles, const Domain& domain)
    : domain_(domain) {
  if (triangles.empty()) return;
  inside_.assign(static_cast<std::size_t>(kSize * kSize), 0);
  for (const auto& t : triangles) {
    double x[3], y[3];
    for (int k = 0; k < 3; ++k)
      x[k] = domain.to_unit_u(t[2 * k]) * kSize, y[k] = domain.to_unit_v(t[2 * k + 1]) * kSize;
    const auto from = [](const double* a) {
      return std::clamp<Index>(static_cast<Index>(*std::min_element(a, a + 3)) - 1, 0, kSize - 1);
    };
    const auto to = [](const double* a) {
      return std::clamp<Index>(static_cast<Index>(*std::max_element(a, a + 3)) + 1, 0, kSize - 1);
    };
    const double turn = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]) < 0 ? -1 : 1;
    for (Index i = from(x); i <= to(x); ++i)
      for (Index j = from(y); j <= to(y); ++j) {
        const double p = static_cast<double>(i) + 0.5, q = static_cast<double>(j) + 0.5;
        bool in = true;
        for (int k = 0; k < 3; ++k) {
          const int l = (k + 1) % 3;
          in = in && turn * ((x[l] - x[k]) * (q - y[k]) - (y[l] - y[k]) * (p - x[k])) >= 0;
        }
        if (in) inside_[static_cast<std::size_t>(i * kSize + j)] = 1;
      }
  }
}

bool OpeningField::inside(double u, double v) const {
  if (empty()) return false;
  return inside_[static_cast<std::size_t>(cell_of(domain_.to_unit_u(u), kSize) * kSize +
                                          cell_of(domain_.to_unit_v(v), kSize))] != 0;
}

}  // namespace knotfit::report
