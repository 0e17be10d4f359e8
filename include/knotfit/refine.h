// To a tolerance: the fewest control points that hold it.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "knotfit/tolerance.h"
namespace knotfit::verify {  // not exported
class SwingSites;
}

namespace [[gnu::visibility("default")]] knotfit {

enum class RefineRoute {
  search,  ///< sizes p x q from the error model, knots placed anew at each [METHOD 4.1]
  insert   ///< isolines inserted where features or errors are large, re-optimised [Zhang16]
};

/// How much work a search with the method "optimal" may take. Counted in fits, never in seconds.
enum class Effort {
  fast,      ///< knots optimised, no relocation, least squares only
  balanced,  ///< relocation and joint minimax; a short walk down
  best       ///< every start, every neighbour, second tries
};

/// What a search to a tolerance is told beside the tolerance.
struct SearchOptions : KnotOptions {
  RefineRoute route = RefineRoute::search;
  /// Placement method: "optimal" needs the fewest control points, "error-model" the least time.
  std::string method = "optimal";
  Effort effort = Effort::balanced;
  /// Method "optimal": hold the surface between the data too, by fill points and a reserve of local
  /// references [METHOD 4.4].
  bool guard = true;
  /// Spans in u over spans in v that the size search grows with, 1/5 to 5 of it counts; 0: by the densities of the
  /// error model [METHOD 4.1]. A map of a mesh knows it: MapQuality::aspect.
  double span_ratio = 0;
  /// Most control points; 0: half of the points, and for scattered data at most 50 000.
  Index max_control_points = 0;
  /// Most linear fits of one search; 0: by the effort (placed knots 3 000; optimal: fast 2 000, balanced
  /// 12 000, best 80 000). Budgets count fits, never seconds, so that a result does not depend on the
  /// machine.
  long max_fits = 0;
};

struct RefineOptions : SearchOptions {
  Tolerance tolerance;
  double noise = 0;  ///< standard deviation of the noise in the data, where known
  /// Of these points, made once a call and handed down; none: made by the search.
  std::shared_ptr<const DataEnergy> energy;
  std::shared_ptr<const verify::SwingSites> sites;
};

/// How a result stands to what was asked. Names as printed by to_string.
enum class Status {
  not_run,
  fixed_size,             ///< no tolerance asked
  reached,                ///< the tolerance holds at the points
  not_reached,            ///< a fixed size or given knots do not hold the tolerance
  data_too_sparse,        ///< half as many control points as points, and still above it
  tolerance_below_noise,  ///< more control points only follow the noise
  swings,         ///< the tolerance holds at the points, but the surface swings between them (SwingReport)
  folded,         ///< the tolerance holds at the vertices, but the surface folds over the mesh
  limit_reached,  ///< SearchOptions::max_control_points or the budget of fits used up
  time_limit,     ///< Control::time_limit cut it short
  stopped,        ///< the caller's stop token
  failed          ///< a surface that is not finite, or whose recheck differs
};
std::string_view to_string(Status status);

/// One size tried.
struct SizeTried {
  int size_u = 0, size_v = 0;  ///< control points; of a curve size_v is 1
  double error = 0;            ///< the error that counts
  bool holds = false;
};

struct RefineResult {
  Status status = Status::not_run;
  /// Of the best surface: the smallest that holds and does not swing, else the least error among those that do not.
  InteriorKnots knots;
  double error = 0;  ///< the error that counts, there
  long fits = 0;
  std::string method;              ///< the knots' own; not the one asked for where that cannot pay
  std::vector<SizeTried> tried;    ///< in order
  InteriorKnots metric;            ///< fine error-model knots (for BetweenOptions); may be empty
  Surface surface;                 ///< the best; with minimax its control points are not the least squares'
  bool least_squares = true;       ///< they are
  InteriorKnots nearest;           ///< of the surface of least error of all tried, whether it swings or not
  bool holds = false;              ///< the best surface holds the tolerance and does not swing
  bool swings = false;             ///< the best surface does: none was found that does not
  Index fill_points = 0;           ///< places between the data that the surface was held at
  Index sample = 0;                ///< points of the sample that its knots were placed or moved on; 0: all
  std::vector<std::string> notes;  ///< what a user should know of the search, a sentence each
};

/// The scale of make_data_energy() for a tolerance: three times one in root mean square, else itself.
double energy_scale(const Tolerance& tolerance);
/// The energy for a surface that misses the tolerance: its scale is that surface's error, but at least the tolerance's
/// [METHOD 5.1]. \param error  >= 0, in the points' unit \param indexed  as make_data_energy()
/// \throws InvalidInput  as make_data_energy()
std::shared_ptr<const DataEnergy> own_energy(const ParameterizedPoints& points, const Tolerance& tolerance,
                                             double error, std::shared_ptr<const IndexedPoints> indexed = {});

/// \throws InvalidInput  tolerance <= 0 or not finite, a span ratio that is negative or not finite, or below rounding of the data; unknown method
RefineResult refine_to_tolerance(const ParameterizedPoints& points, const RefineOptions& options,
                                 const Control& control = {});

}  // namespace knotfit
