// A result checked on paths of its own: residuals that share no code with the fit, and the
// honest numbers between the data.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/curve.h"
#include "knotfit/curve_points.h"
#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace knotfit {  // not exported

struct IndexedPoints;  // data/indexed_points.h

}  // namespace knotfit

namespace [[gnu::visibility("default")]] knotfit {

/// Errors |S(u_k,v_k) - P_k| of every point by de Boor's algorithm on the control net
/// [deBoor01], apart from the fit's and the library's own evaluation.
/// \return n errors in input order; an entry is NaN where the surface is not finite there
std::vector<double> recheck_errors(const Surface& surface, const ParameterizedPoints& points);

struct BetweenOptions {
  Index random_places = 3000;  ///< uniformly random in the domain
  Index gap_places = 1000;     ///< the widest gaps and border places
  Index cell_places = 500;     ///< at most: middles of knot cells that hold fewer than three points
  unsigned long long seed = 1;
  /// Interior knots (u, v) of an error-model net: the second metric where the first is unsure;
  /// empty: none.
  std::vector<double> metric_u, metric_v;
  /// Of these points, made once a call and handed down; none: made here.
  std::shared_ptr<const IndexedPoints> indexed;
};

/// A place where the data is too thin to promise anything.
struct ThinPlace {
  double u = 0, v = 0;
  double error_bar = 0;  ///< e of the local reference there; infinity where it has none
  double gap = 0;        ///< distance to the nearest point over the radius of its neighbours
};

/// The surface between the points against a local polyharmonic reference [METHOD 5.3]. Promised: error bar
/// e <= tolerance / 2 and no hole (nearest point within 0.35 h). The largest of the places tried are climbed from, so
/// that `between` and `bound` are those of the tops and not of a sample.
struct BetweenReport {
  bool measured = false;            ///< false where stopped or out of time: all else is empty then
  std::optional<double> between;    ///< max |S - z*| over promised places; none where nothing is promised
  std::optional<double> bound;      ///< max (|S - z*| + 2 e) over promised places; likewise
  double thin = 0;                  ///< share of the domain (random places) not promised
  double worst_u = 0, worst_v = 0;  ///< where `between` is
  Index promised = 0, places = 0;
  double noise = 0;  ///< standard deviation of the noise found, per component; 0: below 0.02 tolerance
  std::vector<ThinPlace> thin_places;  ///< all places tried that are not promised
};

/// \param tolerance  > 0, absolute
BetweenReport measure_between(const Surface& surface, const ParameterizedPoints& points, double tolerance,
                              const BetweenOptions& options = {}, const Control& control = {});

/// Whether a surface keeps to its data where points stand side by side. A swing is how far S leaves the box of the 16
/// nearest points and of its triangle's corners, over the larger of the tolerance and the largest error of the 8 nearest, at places inside small
/// triangles of neighbours (edges at most three times the distance to the fourth neighbour). Places where S is within three times
/// that of the local reference are none: a crest between points leaves their box, and the data says so [METHOD 5.2].
struct SwingReport {
  bool measured = false;
  Index places = 0;                 ///< random places inside small triangles
  Index above = 0;                  ///< of them, those where the swing is above 3
  double largest = 0;               ///< the largest swing, in narrow knot cells and gaps too
  double distance = 0;              ///< how far S leaves the box there, in the data's unit
  bool in_gap = false;              ///< it lies in a gap, where the box is widened [METHOD 5.2]
  double worst_u = 0, worst_v = 0;  ///< where
  double beyond_box = 0;            ///< how far S leaves the box of all data, anywhere in the domain
  double box_u = 0, box_v = 0;      ///< where
  /// A place above 10, more than 1 in 2000 above 3, or beyond the box of all data by more than 2 % of its diagonal and
  /// two tolerances, not counting what the data about goes on to beyond its outermost points.
  bool swings = false;
};

/// \param errors     n, |S - P| of every point in input order
/// \param tolerance  > 0, absolute
/// \throws InvalidInput  points invalid, a surface or errors that do not belong to them
SwingReport measure_swings(const Surface& surface, const ParameterizedPoints& points,
                           const std::vector<double>& errors, double tolerance);

/// Of a curve: boxes of the 4 nearest points and the gap's ends, errors of the 2 nearest, in gaps of at most three times the
/// distance to the second neighbour. A crest that the polynomials through its neighbours confirm is none.
/// [METHOD 9.5]
/// \param curve      over [0,1]
/// \param points     n, their parameters on it
/// \param errors     n, |C(t_k) - P_k|
/// \param tolerance  > 0, absolute
/// \throws InvalidInput  points invalid, a curve or errors that do not belong to them, a tolerance that is not positive and finite
SwingReport measure_swings(const Curve& curve, const CurvePoints& points, const std::vector<double>& errors,
                           double tolerance);

/// Standard deviation of the noise in the values, by restricted likelihood of a nugget on random
/// local stencils (median) [METHOD 5.3]; 0 where there are too few points to tell.
double estimate_noise(const ParameterizedPoints& points, unsigned long long seed = 1);
/// Of a curve: from what every point is off the cubic through its four neighbours (median); interpolation's own error where
/// the data has no noise [METHOD 9.4]. 0 below 8 distinct parameters. \throws InvalidInput  points invalid
double estimate_noise(const CurvePoints& points);

}  // namespace knotfit
