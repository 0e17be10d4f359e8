#include "solve/data_raster.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel.h"
#include "data/parameter_groups.h"
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
constexpr Index kNearAlong = 8, kMostAlong = 4000;  // of a curve: points about a place, cells a period

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

/// Weights of bending and slope about a place.
struct Weights {
  double bend, slope;
  /// \param hole   0 where data is, 1 where none is
  /// \param tau2   square of how far the data is from flat there, range2 of its range, t2 of the scale
  Weights(double hole, double spacing, double tau2, double range2, double t2)
      : bend(std::pow(kBend, 1 - hole) * std::pow(kBendHole, hole) * spacing * spacing * t2 / (tau2 + t2)),
        slope(std::pow(kSlope, 1 - hole) * std::pow(kSlopeHole, hole) * t2 /
              (kRangeShare * range2 + tau2 + t2)) {}
};

/// How much of a hole a place is, from the distances to the nearest point and to the farthest of those about.
double hole_share(double nearest, double farthest) {
  return farthest > 0 ? smoothstep((nearest / farthest - kHoleBegins) / (kHoleIs - kHoleBegins)) : 0;
}

/// Distinct parameters of a curve in order, their mean values; of a closed one its neighbouring periods too.
struct CurvePlaces {
  int dimension;
  Index first = 0, count = 0;  ///< those of the period itself
  std::vector<double> t, values;

  explicit CurvePlaces(const CurvePoints& points) : dimension(points.dimension) {
    const ParameterGroups groups = group_by_parameter(points.t);
    for (Index g = 0; g < groups.size(); ++g) {
      std::vector<double> sum(dimension, 0.0);
      for (const Index k : groups.group(g))
        for (int e = 0; e < dimension; ++e) sum[e] += points.value(k)[e];
      t.push_back(points.t[groups.group(g).front()]);
      for (double x : sum) values.push_back(x / static_cast<double>(groups.group(g).size()));
    }
    count = static_cast<Index>(t.size());
    if (!points.closed) return;
    const std::vector<double> period = t, of_period = values;
    t.clear(), values.clear();
    for (int turn = -1; turn < 2; ++turn) {
      for (double x : period) t.push_back(x + turn);
      values.insert(values.end(), of_period.begin(), of_period.end());
    }
    first = count;
  }
  const double* value(Index k) const { return values.data() + k * dimension; }
  /// The nearest so many, a window [begin, begin + wanted) of neighbours.
  Index nearest(double at, Index wanted) const {
    const Index n = static_cast<Index>(t.size());
    Index begin = std::lower_bound(t.begin(), t.end(), at) - t.begin() - wanted;
    begin = std::clamp<Index>(begin, 0, n - wanted);
    while (begin + wanted < n && t[begin + wanted] - at < at - t[begin]) ++begin;
    return begin;
  }
};

}  // namespace

DataRaster::DataRaster(int dimension_, Index side_u_, Index side_v_, double end_u_)
    : dimension(dimension_), side_u(side_u_), side_v(side_v_), end_u(end_u_) {
  weight.assign(cells() * kKinds, 0.0);
  goal.assign(cells() * kKinds * dimension, 0.0);
  spacing_u.assign(cells(), 1.0);
  spacing_v.assign(cells(), 1.0);
}

DataRaster data_raster(const ParameterizedPoints& points, double scale,
                       std::shared_ptr<const IndexedPoints> indexed) {
  indexed = indexed_or(std::move(indexed), points);
  const DistinctPoints& distinct = indexed->distinct;
  const Neighbours& neighbours = indexed->neighbours;
  const Index n =
      std::clamp<Index>(static_cast<Index>(2 * std::sqrt(static_cast<double>(distinct.size()))), 16, 200);
  const int d = points.dimension;
  DataRaster raster(d, n, n, 1);
  parallel_for(n, [&](Index i) {
    LocalFit local(distinct, neighbours);
    for (Index j = 0; j < n; ++j) {
      const Index cell = i * n + j;
      local.gather((static_cast<double>(i) + 0.5) / static_cast<double>(n),
                   (static_cast<double>(j) + 0.5) / static_cast<double>(n));
      const double h = local.radius();
      const double hole = hole_share(local.nearest(), h);
      std::array<double, kNear> residual2{};
      double range2 = 0;
      const bool goals_known = local.count() >= kLeastForGoals && h > 0;
      double* goal = raster.goal.data() + cell * DataRaster::kKinds * d;
      for (int e = 0; e < d; ++e) {
        const Eigen::Matrix<double, 6, 1> z = local.component(e, residual2, range2);
        if (!goals_known) continue;
        goal[DataRaster::kUu * d + e] = (1 - hole) * 2 * z(3) / (h * h);
        goal[DataRaster::kUv * d + e] = (1 - hole) * z(4) / (h * h);
        goal[DataRaster::kVv * d + e] = (1 - hole) * 2 * z(5) / (h * h);
        goal[DataRaster::kU * d + e] = (1 - hole) * z(1) / h;
        goal[DataRaster::kV * d + e] = (1 - hole) * z(2) / h;
      }
      const double tau2 = *std::max_element(residual2.begin(), residual2.end());
      const double spacing = h * std::sqrt(std::numbers::pi / static_cast<double>(local.count()));
      const auto [bend, slope] = Weights(hole, spacing, tau2, range2, scale * scale);
      const double ratio = local.anisotropy();
      raster.spacing_u[cell] = spacing / std::sqrt(ratio);
      raster.spacing_v[cell] = spacing * std::sqrt(ratio);
      // In coordinates in which the data is even, bending and slope weigh the same every way.
      const double weights[] = {bend / (ratio * ratio), 2 * bend, bend * ratio * ratio, slope / ratio,
                                slope * ratio};
      for (int k = 0; k < DataRaster::kKinds; ++k) {
        raster.weight[cell * DataRaster::kKinds + k] = weights[k];
        for (int e = 0; e < d; ++e) goal[k * d + e] *= weights[k];
      }
    }
  });
  return raster;
}

DataRaster strip_raster(const CurvePoints& points, double scale) {
  const CurvePlaces places(points);
  const int d = points.dimension, extra = d > 1 ? 1 : 0;  // the strip's own component does not change along u
  const Index a_period = std::clamp<Index>(2 * places.count, 16, kMostAlong),
              near = std::min<Index>(kNearAlong, static_cast<Index>(places.t.size()));
  const double end = points.closed ? 2 : 1;
  DataRaster raster(d + extra, points.closed ? 2 * a_period : a_period, 1, end);
  for (Index i = 0; i < raster.side_u; ++i) {
    const double at = (static_cast<double>(i % a_period) + 0.5) / static_cast<double>(a_period);
    const Index begin = places.nearest(at, near);
    const double h = std::max(at - places.t[begin], places.t[begin + near - 1] - at);
    double nearest = INFINITY;
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    auto monomials = [&](Index k) {
      const double x = h > 0 ? (places.t[begin + k] - at) / h : 0;
      return Eigen::Vector3d(1, x, x * x);
    };
    for (Index k = 0; k < near; ++k) {
      nearest = std::min(nearest, std::abs(places.t[begin + k] - at));
      gram += monomials(k) * monomials(k).transpose();
    }
    for (int r = 1; r < 3; ++r) gram(r, r) += (r == 1 ? 1e-10 : kRidge) * static_cast<double>(near);
    const double hole = hole_share(nearest, h);
    const Eigen::LDLT<Eigen::Matrix3d> quadratic(gram);
    const Eigen::LDLT<Eigen::Matrix2d> line(gram.topLeftCorner<2, 2>());
    double* goal = raster.goal.data() + i * DataRaster::kKinds * raster.dimension;
    std::vector<double> residual2(near, 0.0);
    double range2 = 0;
    for (int e = 0; e < d; ++e) {
      const double mid = places.value(begin)[e];
      double low = INFINITY, high = -INFINITY;
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (Index k = 0; k < near; ++k) {
        const double z = places.value(begin + k)[e];
        low = std::min(low, z), high = std::max(high, z);
        right += (z - mid) * monomials(k);
      }
      range2 += (high - low) * (high - low);
      const Eigen::Vector3d z = quadratic.solve(right);
      const Eigen::Vector2d flat = line.solve(right.head<2>());
      for (Index k = 0; k < near; ++k) {
        const double r = places.value(begin + k)[e] - mid - flat.dot(monomials(k).head<2>());
        residual2[k] += r * r;
      }
      if (near < kLeastForGoals || !(h > 0)) continue;
      goal[DataRaster::kUu * raster.dimension + e] = (1 - hole) * 2 * z(2) / (h * h);
      goal[DataRaster::kU * raster.dimension + e] = (1 - hole) * z(1) / h;
    }
    const double tau2 = *std::max_element(residual2.begin(), residual2.end());
    const double spacing = 2 * h / static_cast<double>(near);
    raster.spacing_u[i] = spacing;
    const Weights w(hole, spacing, tau2, range2, scale * scale);
    // As on surfaces for each point; on the strip it stands twice.
    for (const auto& [kind, weight] : {std::pair{DataRaster::kUu, 2 * w.bend * spacing},
                                       std::pair{DataRaster::kU, 2 * w.slope * spacing}}) {
      raster.weight[i * DataRaster::kKinds + kind] = weight;
      for (int e = 0; e < raster.dimension; ++e) goal[kind * raster.dimension + e] *= weight;
    }
  }
  return raster;
}

}  // namespace knotfit
