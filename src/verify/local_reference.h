// What the data says between its points, without a net: local polyharmonic kriging.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "data/distinct_points.h"
#include "data/indexed_points.h"
#include "verify/kriging.h"
namespace knotfit::verify {

/// Points and degree of a stencil: kernel r^(2 degree + 1), k nearest points.
struct StencilShape {
  int degree = 4;
  Index points = 80;
};
inline constexpr StencilShape kPlainShape{4, 80};   ///< in the parameters themselves
inline constexpr StencilShape kMappedShape{3, 60};  ///< in error-model coordinates, and to find noise
inline constexpr double kHole =
    0.35;  ///< a nearest point farther than this share of the stencil's radius: a hole

/// The shape for n points: the one wished for, or the next smaller where they are fewer than its points.
StencilShape shape_for(StencilShape wished, Index n);

/// z*, its error bar and how thin the data is at a place.
struct ReferenceValue {
  std::vector<double> value;  ///< a component each; NaN where there is none
  double error_bar = std::numeric_limits<double>::infinity();
  double gap = std::numeric_limits<double>::infinity();  ///< nearest point over the stencil's radius
};

/// A stencil gathered about places, one after the other.
class StencilGatherer {
 public:
  StencilGatherer(const DistinctPoints& points, const Neighbours& neighbours, StencilShape shape);
  /// Gathers the stencil at (x, y) in the neighbours' coordinates and sets the kriging up.
  /// \return the degree in force; 0: nothing can be said there
  int gather(double x, double y);
  Kriging& kriging() { return kriging_; }
  double gap() const { return gap_; }  ///< nearest point over the radius
  double scale() const {
    return scale_;
  }  ///< the stencil's values are (value - centre) / scale; 0: all equal
  std::span<const double> centre() const { return centre_; }

 private:
  const DistinctPoints& points_;
  const Neighbours& neighbours_;
  StencilShape shape_;
  Kriging kriging_;
  std::vector<std::uint32_t> index_;
  std::vector<double> squared_, x_, y_, values_, weights_, centre_;
  double gap_ = 0, scale_ = 0;
};

/// z* and e at (x, y). \param noise  standard deviation of the noise in the values, 0: none
ReferenceValue reference_value(StencilGatherer& gatherer, double x, double y, double noise);

/// The plain and the mapped reference in one: the smaller error bar counts, but never less than a quarter
/// of what the two differ by (without that the mapped one was confidently wrong) [METHOD 5.3].
/// A place where either has no error bar at all keeps what the plain one says.
ReferenceValue combine(ReferenceValue plain, const ReferenceValue& mapped);

/// Noise by the median over `stencils` random points; 0 where there are too few points to tell.
double find_noise(const IndexedPoints& points, unsigned long long seed = 1, Index stencils = 100);

}  // namespace knotfit::verify
