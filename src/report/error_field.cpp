#include "report/error_field.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
namespace knotfit::report {
namespace {

constexpr Index kReach = 4;  // cells

Index cell_of(double t, Index size) {
  return std::clamp<Index>(static_cast<Index>(std::floor(t * static_cast<double>(size))), 0, size - 1);
}

}  // namespace

ErrorField::ErrorField(const ParameterizedPoints& points, const std::vector<double>& errors,
                       const Domain& domain)
    : domain_(domain) {
  const Index n = points.size();
  if (n == 0 || errors.empty()) return;
  // About one point a cell: as fine as the data tells.
  size_ = std::clamp<Index>(static_cast<Index>(std::sqrt(static_cast<double>(n))), 12, 400);
  const auto cells = static_cast<std::size_t>(size_ * size_);
  std::vector<double> own(cells, NAN);
  for (Index k = 0; k < n; ++k) {
    double& cell = own[cell_of(domain.to_unit_u(points.u(k)), size_) * size_ +
                       cell_of(domain.to_unit_v(points.v(k)), size_)];
    if (std::isnan(cell) || std::abs(errors[k]) > std::abs(cell)) cell = errors[k];
  }
  value_.assign(cells, NAN);
  parallel_for(size_, [&](Index i) {
    for (Index j = 0; j < size_; ++j) {
      Index nearest = kReach * kReach + 1;
      for (Index a = std::max<Index>(0, i - kReach); a <= std::min(size_ - 1, i + kReach); ++a)
        for (Index b = std::max<Index>(0, j - kReach); b <= std::min(size_ - 1, j + kReach); ++b) {
          const Index square = (a - i) * (a - i) + (b - j) * (b - j);
          if (square >= nearest || std::isnan(own[a * size_ + b])) continue;
          nearest = square;
          value_[i * size_ + j] = own[a * size_ + b];
        }
    }
  });
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

}  // namespace knotfit::report
