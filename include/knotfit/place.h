// Where the knots go. One method is one file of src/place/ and one line of methods.cpp.
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/features.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/interior_knots.h"
#include "knotfit/points.h"
#include "knotfit/tolerance.h"
namespace [[gnu::visibility("default")]] knotfit {

/// What the fits are made on that place or move knots. The verdict is always on all points.
enum class Engine {
  automatic,  ///< a sample where that is much less work
  points,     ///< all points
  sample  ///< a sample of them; the worst of all points join it until the tolerance holds at every one [METHOD 6.4]
};

/// What whoever places knots is told, at one size or in a search.
struct KnotOptions {
  int degree_u = 3, degree_v = 3;                    ///< 1 to 9
  double smoothing = 1e-9;                           ///< relative floor of every fit, as LeastSquaresOptions
  FeatureMeasure feature = FeatureMeasure::hessian;  ///< of the criterion
  FeatureMap user_features;                          ///< used in place of `feature` where not empty
  long evaluations = 2000;                           ///< of the error, in an evolutionary search at one size
  Engine engine = Engine::automatic;                 ///< of methods that move knots or fit again and again
};

struct PlacementOptions : KnotOptions {
  int interior_u = 8, interior_v = 8;        ///< interior knots wanted, >= 0
  double stop = 1e-5;                        ///< criterion: largest knot move of a sweep that ends it
  int sweeps = 100;                          ///< criterion: at most
  int rounds = 12;                           ///< error model: rounds at the counts wanted
  std::shared_ptr<const DataEnergy> energy;  ///< of the fits a method makes, as LeastSquaresOptions
  /// Error model: the round kept has the least error of this measure; no further round once it is at
  /// most the value (0: all rounds).
  Tolerance keep_by{.value = 0, .measure = ErrorMeasure::rms};
};

enum class PlacementStatus { not_run, converged, limit, stopped };
struct Placement {
  InteriorKnots knots;
  PlacementStatus status = PlacementStatus::not_run;
  double criterion = 0;              ///< E(U,V) reached (sum of squared shares); 0 where a method has none
  double criterion_start = 0;        ///< E(U,V) of its start
  long fits = 0;                     ///< linear fits made
  Index sample = 0;                  ///< points of the sample that the knots were placed or moved on; 0: all
  std::vector<std::string> notes{};  ///< what a user should know, a sentence each
};

/// What becomes of a method's knots on a mesh whose parameters move [METHOD 8.12].
enum class MeshKnots {
  placed_once,  ///< at the map's parameters; the correction keeps them
  uniform,      ///< equally spaced throughout
  anew,         ///< by the error model on the corrected surface
  moved         ///< that, and then moved so that the distances fall
};

/// What others need to know of a method beside its knots.
struct MethodTraits {
  bool moves_knots =
      false;            ///< knots minimise the error itself, on scattered points whatever the data's layout
  bool refits = false;  ///< fits again and again at one size: of many points, a sample will do [METHOD 6.4]
  bool needs_rows = false;  ///< points that are not in rows are gathered into rows first, which a note says
  MeshKnots on_mesh = MeshKnots::placed_once;
};

/// A row of the table of methods.
struct PlacementMethod {
  std::string_view name;     ///< such as "error-model"
  std::string_view summary;  ///< one line
  std::string_view source;   ///< paper, section
  MethodTraits traits{};
};
/// Every method there is, in the order of the docs.
std::span<const PlacementMethod> placement_methods();
/// The method of that name. \throws InvalidInput  unknown; lists those there are
const PlacementMethod& placement_method(std::string_view name);

/// A row of the table of feature measures, which FeatureMeasure numbers.
struct FeatureMeasureInfo {
  FeatureMeasure measure;
  std::string_view name;     ///< such as "hessian"
  std::string_view summary;  ///< one line
};
std::span<const FeatureMeasureInfo> feature_measures();

/// Places knots by the method of that name.
/// \throws InvalidInput  an unknown name (lists those there are), options out of range
Placement place_knots(std::string_view method, const ParameterizedPoints& points,
                      const PlacementOptions& options = {}, const Control& control = {});

/// Removes the knot of least loss, of either direction, while the fit without it holds the tolerance.
/// \return what is left; status limit where the knots given do not hold it
/// \throws InvalidInput  a tolerance that is not positive, points or knots invalid
Placement prune_knots(const ParameterizedPoints& points, InteriorKnots knots, const Tolerance& tolerance,
                      const PlacementOptions& options = {}, const Control& control = {});

/// The cell criterion E(U,V) = sum_ij F_ij^2, F_ij the share of f in cell ij [Zhang16; METHOD 2.2].
double cell_criterion(const FeatureMap& features, const InteriorKnots& knots);
/// Coordinate descent on it from `start`: exact minimum over each knot in turn, E never rises;
/// ends where no single knot lowers it, or after `sweeps`.
Placement descend_criterion(const FeatureMap& features, InteriorKnots start, double stop = 1e-5,
                            int sweeps = 100);
/// Equal shares of the marginals of f.
InteriorKnots equal_share(const FeatureMap& features, int interior_u, int interior_v);

}  // namespace knotfit
