// Errors of points spread over the parameter domain, and where the data is too thin.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/verify.h"
#include "report/vectors.h"
namespace knotfit::report {

/// The domain of a surface, which need not be [0,1]^2.
struct Domain {
  double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
  double to_unit_u(double u) const { return (u - u0) / (u1 - u0); }
  double to_unit_v(double v) const { return (v - v0) / (v1 - v0); }
};

/// On each cell of a grid the signed error of the point with the largest |error| there; cells
/// without a point take the nearest cell's, up to four mean distances of points away.
class ErrorField {
 public:
  ErrorField() = default;
  ErrorField(const ParameterizedPoints& points, const std::vector<double>& signed_errors,
             const Domain& domain);
  bool empty() const { return value_.empty(); }
  /// Between cell centres linearly over the cells that have a value; nothing where no data is near.
  std::optional<double> at(double u, double v) const;
  Index size() const { return size_; }

 private:
  Domain domain_;
  Index size_ = 0;
  std::vector<double> value_;  // NaN: no data near
};

/// Where the data is too thin to promise anything: within a small radius of a thin place.
class ThinField {
 public:
  ThinField() = default;
  ThinField(const std::vector<ThinPlace>& places, const Domain& domain);
  bool empty() const { return distance_.empty(); }
  /// Distance to the nearest thin place over the radius, in the unit square: < 1 is thin.
  double ratio(double u, double v) const;
  /// The border of the thin region: ends of segments in the unit square, two by two.
  std::vector<Vec2> outline() const;

 private:
  double at(Index i, Index j) const { return distance_[static_cast<std::size_t>(i * kSize + j)]; }
  static constexpr Index kSize = 193;       // nodes a direction
  static constexpr double kRadius = 0.026;  // 1.4 mean distances of the 3000 random places tried
  Domain domain_;
  std::vector<double> distance_;
};

/// Openings of the data, as cells of the unit square.
class OpeningField {
 public:
  OpeningField() = default;
  /// \param triangles  (u, v) of each corner
  OpeningField(const std::vector<std::array<double, 6>>& triangles, const Domain& domain);
  bool empty() const { return inside_.empty(); }
  bool inside(double u, double v) const;

 private:
  static constexpr Index kSize = 512;  // cells a direction
  Domain domain_;
  std::vector<char> inside_;
};

}  // namespace knotfit::report
