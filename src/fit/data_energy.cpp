#include "fit/data_energy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "data/neighbours.h"
namespace knotfit {
namespace {

// Measured constants [METHOD 5.1]: weights where data is, in holes, and of the range in the slopes'.
constexpr double kBend = 0.03, kBendHole = 0.3;
constexpr double kSlope = 0.0015, kSlopeHole = 0.3;
constexpr double kRangeShare = 1.0 / 64;
constexpr Index kNear = 24;  // points that say how the data is about a place
constexpr double kHoleBegins = 0.25,
                 kHoleIs = 0.5;      // distance to the nearest point over that to the farthest of them
constexpr double kRidge = 1e-3;      // on the quadratic terms of the local fit, a point
constexpr Index kLeastForGoals = 8;  // points below which there is no local quadratic
constexpr double kRowsBegin = 5;     // ratio of spacings up to which the data counts as even
constexpr double kRowsMost = 30;
// Cells of at most so many raster cells are added up one by one: differences of sums would lose their digits.
constexpr Index kFewFragments = 16;

double smoothstep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Largest gap between neighbours of sorted offsets: the spacing across rows, where there are any.
double largest_gap(std::array<double, kNear>& x, Index count) {
  std::sort(x.begin(), x.begin() + count);
  double gap = 0;
  for (Index i = 1; i < count; ++i) gap = std::max(gap, x[i] - x[i - 1]);
  return gap;
}

Index raster_cell(double x, Index side) {
  return std::clamp<Index>(static_cast<Index>(x * static_cast<double>(side)), 0, side - 1);
}

/// The 24 nearest points about a place, in offsets over the distance of the farthest.
class LocalFit {
 public:
  LocalFit(const DistinctPoints& points, const Neighbours& neighbours)
      : points_(points),
        neighbours_(neighbours),
        index_(std::min(kNear, points.size())),
        squared_(index_.size()) {}

  void gather(double u, double v) {
    count_ = neighbours_.nearest(u, v, index_, squared_);
    radius_ = std::sqrt(squared_[count_ - 1]);
    const double scale = radius_ > 0 ? 1 / radius_ : 0;
    for (Index k = 0; k < count_; ++k) {
      x_[k] = (points_.u[index_[k]] - u) * scale;
      y_[k] = (points_.v[index_[k]] - v) * scale;
    }
    gram_.setZero();
    for (Index k = 0; k < count_; ++k) {
      const Eigen::Matrix<double, 6, 1> m = monomials(k);
      gram_.noalias() += m * m.transpose();
    }
    // Points on a line leave the slope across it open: 0 then.
    plane_.compute(gram_.topLeftCorner<3, 3>() +
                   (1e-10 * static_cast<double>(count_)) * Eigen::Matrix3d::Identity());
    for (int i = 3; i < 6; ++i) gram_(i, i) += kRidge * static_cast<double>(count_);
    for (int i = 1; i < 3; ++i) gram_(i, i) += 1e-10 * static_cast<double>(count_);
    quadratic_.compute(gram_);
  }

  /// Adds one component: squares of residuals from its plane to a point each, its squared range. \return the quadratic's coefficients
  Eigen::Matrix<double, 6, 1> component(int e, std::array<double, kNear>& residual2, double& range2) const {
    double low = INFINITY, high = -INFINITY, sum = 0;
    for (Index k = 0; k < count_; ++k) {
      const double z = points_.value(index_[k])[e];
      low = std::min(low, z), high = std::max(high, z), sum += z;
    }
    const double mean = sum / static_cast<double>(count_);
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (Index k = 0; k < count_; ++k) right += (points_.value(index_[k])[e] - mean) * monomials(k);
    const Eigen::Vector3d plane = plane_.solve(right.head<3>());
    for (Index k = 0; k < count_; ++k) {
      const double r = points_.value(index_[k])[e] - mean - plane(0) - plane(1) * x_[k] - plane(2) * y_[k];
      residual2[k] += r * r;
    }
    range2 += (high - low) * (high - low);
    return quadratic_.solve(right);
  }

  Index count() const { return count_; }
  double radius() const { return radius_; }
  double nearest() const { return std::sqrt(squared_[0]); }
  /// Spacing along v over that along u, 1 where the data is even.
  double anisotropy() const {
    std::array<double, kNear> x = x_, y = y_;
    const double across = largest_gap(y, count_), along = largest_gap(x, count_);
    if (!(across > 0) || !(along > 0)) return across > 0 ? kRowsMost : along > 0 ? 1 / kRowsMost : 1;
    const double ratio = across / along;
    if (ratio > kRowsBegin) return std::min(ratio / kRowsBegin, kRowsMost);
    return ratio < 1 / kRowsBegin ? std::max(ratio * kRowsBegin, 1 / kRowsMost) : 1;
  }

 private:
  Eigen::Matrix<double, 6, 1> monomials(Index k) const {
    Eigen::Matrix<double, 6, 1> m;
    m << 1, x_[k], y_[k], x_[k] * x_[k], x_[k] * y_[k], y_[k] * y_[k];
    return m;
  }
  const DistinctPoints& points_;
  const Neighbours& neighbours_;
  std::vector<std::uint32_t> index_;
  std::vector<double> squared_;
  std::array<double, kNear> x_{}, y_{};
  Index count_ = 0;
  double radius_ = 0;
  Eigen::Matrix<double, 6, 6> gram_;
  Eigen::LDLT<Eigen::Matrix3d> plane_;
  Eigen::LDLT<Eigen::Matrix<double, 6, 6>> quadratic_;
};

}  // namespace

DataEnergy::DataEnergy(const ParameterizedPoints& points, double scale)
    : dimension_(points.dimension), channels_(kKinds + goal_size()) {
  const DistinctPoints distinct = distinct_points(points);
  const Neighbours neighbours = plain_neighbours(distinct);
  side_ = std::clamp<Index>(static_cast<Index>(2 * std::sqrt(static_cast<double>(distinct.size()))), 16, 200);
  const Index n = side_, nodes = n + 1, goals = Index{kKinds} * dimension_;
  weight_.resize(n * n * kKinds);
  goal_.assign(n * n * goals, 0.0);
  std::vector<double> spacing_u(n * n), spacing_v(n * n);
  const double t2 = scale * scale;
  parallel_for(n, [&](Index i) {
    LocalFit local(distinct, neighbours);
    for (Index j = 0; j < n; ++j) {
      const Index cell = i * n + j;
      local.gather((static_cast<double>(i) + 0.5) / static_cast<double>(n),
                   (static_cast<double>(j) + 0.5) / static_cast<double>(n));
      const double h = local.radius();
      const double hole =
          h > 0 ? smoothstep((local.nearest() / h - kHoleBegins) / (kHoleIs - kHoleBegins)) : 0;
      std::array<double, kNear> residual2{};
      double range2 = 0;
      const bool goals_known = local.count() >= kLeastForGoals && h > 0;
      double* goal = goal_.data() + cell * goals;
      for (int e = 0; e < dimension_; ++e) {
        const Eigen::Matrix<double, 6, 1> z = local.component(e, residual2, range2);
        if (!goals_known) continue;
        goal[kUu * dimension_ + e] = (1 - hole) * 2 * z(3) / (h * h);
        goal[kUv * dimension_ + e] = (1 - hole) * z(4) / (h * h);
        goal[kVv * dimension_ + e] = (1 - hole) * 2 * z(5) / (h * h);
        goal[kU * dimension_ + e] = (1 - hole) * z(1) / h;
        goal[kV * dimension_ + e] = (1 - hole) * z(2) / h;
      }
      const double tau2 = *std::max_element(residual2.begin(), residual2.end());
      const double spacing = h * std::sqrt(std::numbers::pi / static_cast<double>(local.count()));
      const double bend =
          std::pow(kBend, 1 - hole) * std::pow(kBendHole, hole) * spacing * spacing * t2 / (tau2 + t2);
      const double slope =
          std::pow(kSlope, 1 - hole) * std::pow(kSlopeHole, hole) * t2 / (kRangeShare * range2 + tau2 + t2);
      const double ratio = local.anisotropy();
      spacing_u[cell] = spacing / std::sqrt(ratio), spacing_v[cell] = spacing * std::sqrt(ratio);
      // In coordinates in which the data is even, bending and slope weigh the same every way.
      const double weights[] = {bend / (ratio * ratio), 2 * bend, bend * ratio * ratio, slope / ratio,
                                slope * ratio};
      for (int k = 0; k < kKinds; ++k) {
        weight_[cell * kKinds + k] = weights[k];
        for (int e = 0; e < dimension_; ++e) goal[k * dimension_ + e] *= weights[k];
      }
    }
  });
  finest_u_.assign(n, 1.0);
  finest_v_.assign(n, 1.0);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      finest_u_[i] = std::min(finest_u_[i], spacing_u[i * n + j]);
      finest_v_[j] = std::min(finest_v_[j], spacing_v[i * n + j]);
    }
  // Sums over [0,u] x [0,v] at the raster's nodes.
  sums_.assign(nodes * nodes * channels_, 0.0);
  const double step = 1 / static_cast<double>(n);
  for (Index i = 0; i < n; ++i) {
    const double fu[] = {step, step * step * (static_cast<double>(i) + 0.5)};
    for (Index j = 0; j < n; ++j) {
      const double fv[] = {step, step * step * (static_cast<double>(j) + 0.5)};
      const Index cell = i * n + j;
      double* at = sums_.data() + ((i + 1) * nodes + j + 1) * channels_;
      const double *left = at - channels_, *below = at - nodes * channels_, *corner = below - channels_;
      for (int k = 0; k < kKinds; ++k) at[k] = step * step * weight_[cell * kKinds + k];
      for (Index m = 0; m < kOrder * kOrder; ++m)
        for (Index g = 0; g < goals; ++g)
          at[kKinds + m * goals + g] = fu[m / kOrder] * fv[m % kOrder] * goal_[cell * goals + g];
      for (Index c = 0; c < channels_; ++c) at[c] += left[c] + below[c] - corner[c];
    }
  }
}

void DataEnergy::integrate(double u0, double u1, double v0, double v1, double* weight, double* goal,
                           double* scratch) const {
  const std::array<Index, 4> cells = {raster_cell(u0, side_), raster_cell(u1, side_), raster_cell(v0, side_),
                                      raster_cell(v1, side_)};
  const std::array<double, 4> box = {u0, u1, v0, v1};
  if ((cells[1] - cells[0] + 1) * (cells[3] - cells[2] + 1) <= kFewFragments)
    add_fragments(cells, box, weight, goal);
  else
    from_sums(box, weight, goal, scratch);
}

void DataEnergy::add_fragments(const std::array<Index, 4>& cells, const std::array<double, 4>& box,
                               double* weight, double* goal) const {
  const Index goals = Index{kKinds} * dimension_;
  const auto [u0, u1, v0, v1] = box;
  std::fill_n(weight, kKinds, 0.0);
  std::fill_n(goal, goal_size(), 0.0);
  const double step = 1 / static_cast<double>(side_);
  // int 1 and int P_1 over the part of the cell's [low, high] in raster column i, in the cell's own length.
  auto part = [&](Index i, double low, double high, double* moment) {
    const double a = std::max(low, static_cast<double>(i) * step),
                 b = std::min(high, static_cast<double>(i + 1) * step);
    const double x = std::max(0.0, (a - low) / (high - low)), y = std::min(1.0, (b - low) / (high - low));
    moment[0] = (high - low) * std::max(0.0, y - x);
    moment[1] = moment[0] * (x + y - 1);  // P_1 = 2 x - 1
  };
  for (Index i = cells[0]; i <= cells[1]; ++i) {
    double mu[2], mv[2];
    part(i, u0, u1, mu);
    for (Index j = cells[2]; j <= cells[3]; ++j) {
      part(j, v0, v1, mv);
      const Index cell = i * side_ + j;
      for (int k = 0; k < kKinds; ++k) weight[k] += mu[0] * mv[0] * weight_[cell * kKinds + k];
      for (int a = 0; a < kOrder; ++a)
        for (int b = 0; b < kOrder; ++b)
          for (Index g = 0; g < goals; ++g)
            goal[(a * kOrder + b) * goals + g] += mu[a] * mv[b] * goal_[cell * goals + g];
    }
  }
}

void DataEnergy::sums_up_to(double u, double v, double* sums) const {
  const Index i = raster_cell(u, side_), j = raster_cell(v, side_), nodes = side_ + 1;
  const double step = 1 / static_cast<double>(side_);
  // Shares of the cell's own moments of 1 and x up to u: exact for a piecewise constant raster.
  auto shares = [&](double x, Index cell, double* share) {
    const double low = static_cast<double>(cell) * step, high = low + step;
    share[0] = (x - low) / step;
    share[1] = (x * x - low * low) / (high * high - low * low);
  };
  double fu[2], fv[2];
  shares(u, i, fu), shares(v, j, fv);
  const double *p00 = sums_.data() + (i * nodes + j) * channels_, *p01 = p00 + channels_,
               *p10 = p00 + nodes * channels_, *p11 = p10 + channels_;
  auto blend = [&](Index begin, Index count, double x, double y) {
    const double w00 = (1 - x) * (1 - y), w01 = (1 - x) * y, w10 = x * (1 - y), w11 = x * y;
    for (Index c = begin; c < begin + count; ++c)
      sums[c] = w00 * p00[c] + w01 * p01[c] + w10 * p10[c] + w11 * p11[c];
  };
  const Index goals = Index{kKinds} * dimension_;
  blend(0, kKinds, fu[0], fv[0]);
  for (Index a = 0; a < kOrder; ++a)
    for (Index b = 0; b < kOrder; ++b) blend(kKinds + (a * kOrder + b) * goals, goals, fu[a], fv[b]);
}

void DataEnergy::from_sums(const std::array<double, 4>& box, double* weight, double* goal,
                           double* total) const {
  const auto [u0, u1, v0, v1] = box;
  const Index goals = Index{kKinds} * dimension_;
  double* corner = total + channels_;
  sums_up_to(u1, v1, total);
  const std::array<std::array<double, 3>, 3> others = {{{u0, v0, 1}, {u0, v1, -1}, {u1, v0, -1}}};
  for (const auto& [u, v, sign] : others) {
    sums_up_to(u, v, corner);
    for (Index c = 0; c < channels_; ++c) total[c] += sign * corner[c];
  }
  for (int k = 0; k < kKinds; ++k) weight[k] = std::max(0.0, total[k]);
  // Moments of 1, v, u, uv become those of P_0 and P_1 of the cell: P_1 = (2 x - low - high) / (high - low).
  const double *m00 = total + kKinds, *m01 = m00 + goals, *m10 = m01 + goals, *m11 = m10 + goals;
  const double au = 2 / (u1 - u0), bu = -(u0 + u1) / (u1 - u0), av = 2 / (v1 - v0),
               bv = -(v0 + v1) / (v1 - v0);
  for (Index g = 0; g < goals; ++g) {
    goal[g] = m00[g];
    goal[goals + g] = av * m01[g] + bv * m00[g];
    goal[2 * goals + g] = au * m10[g] + bu * m00[g];
    goal[3 * goals + g] = au * av * m11[g] + au * bv * m10[g] + bu * av * m01[g] + bu * bv * m00[g];
  }
}

double DataEnergy::finest_spacing(double low, double high, bool along_v) const {
  const std::vector<double>& finest = along_v ? finest_v_ : finest_u_;
  return *std::min_element(finest.begin() + raster_cell(low, side_),
                           finest.begin() + raster_cell(high, side_) + 1);
}

}  // namespace knotfit
