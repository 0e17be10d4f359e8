// Rows to a tolerance: control points, time, and how far the surface is from the truth between the points.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "data.h"
#include "knotfit/fit_sheared.h"
#include "knotfit/io.h"
#include "knotfit/parameterize.h"
#include "row.h"
#include "support/synthetic.h"
namespace knotfit::bench {
namespace {

const std::vector<std::pair<std::string, Effort>> kEfforts = {
    {"fast", Effort::fast}, {"balanced", Effort::balanced}, {"best", Effort::best}};

FitOptions optimal(double tolerance, Effort effort) {
  FitOptions options;
  options.tolerance = ToleranceRequest{.value = tolerance};
  options.method = "optimal";
  options.effort = effort;
  return options;
}

Figures figures_of(const FitResult& result, const Stopwatch& watch) {
  return {{"status", to_string(result.status)},
          {"control_points", result.surface.control_point_count()},
          {"size_u", result.surface.size_u()},
          {"size_v", result.surface.size_v()},
          {"measured", result.measured / result.tolerance},
          {"fits", result.fits},
          {"user", watch.user()},
          {"wall", watch.wall()},
          {"notes", result.notes}};
}

/// The whole call, with the honest numbers, and the truth beside them. All errors over the tolerance.
Figures guarded(const Data& data, Effort effort) {
  const double tolerance = 1e-3 * data.diagonal;
  const Stopwatch watch;
  const FitResult result = fit_surface(data.points, optimal(tolerance, effort));
  Figures figures = figures_of(result, watch);
  const FreshError fresh = fresh_error(result.surface, data, tolerance);
  figures["fill_points"] = result.fill_points;
  figures["between"] = result.between.between.value_or(0) / tolerance;
  figures["bound"] = result.between.bound.value_or(0) / tolerance;
  figures["thin"] = result.between.thin;
  figures["fresh"] = fresh.all / tolerance;
  figures["fresh_promised"] = fresh.promised / tolerance;
  return figures;
}

/// The search alone, without the noise estimate, comparisons and honest numbers of the whole call.
Figures search_alone(const Data& data, bool guard) {
  RefineOptions options;
  options.tolerance.value = 1e-3 * data.diagonal;
  options.method = "optimal";
  options.guard = guard;
  const Stopwatch watch;
  const RefineResult result = refine_to_tolerance(data.points, options);
  return {{"status", to_string(result.status)},
          {"control_points", result.surface.control_point_count()},
          {"fits", result.fits},
          {"fill_points", result.fill_points},
          {"user", watch.user()},
          {"wall", watch.wall()}};
}

Figures to_rms(const std::string& name, double share, Effort effort, bool guard, std::uint64_t seed) {
  const Data data = make_data(name, 10000, seed);
  FitOptions options = optimal(share * data.diagonal, effort);
  options.tolerance->measure = ErrorMeasure::rms;
  options.guard = guard;
  options.between = false;
  const Stopwatch watch;
  return figures_of(fit_surface(data.points, options), watch);
}

Figures one_of_sweep(const std::string& name, int step) {
  const Data data = make_data(name, 10000, 1);
  const double share = std::pow(10.0, -2 - 2 * step / 39.0);
  FitOptions options = optimal(share * data.diagonal, Effort::balanced);
  options.between = false;
  const Stopwatch watch;
  Figures figures = figures_of(fit_surface(data.points, options), watch);
  figures["tolerance"] = share;
  return figures;
}

Figures by_route(const ParameterizedPoints& points, const ToleranceRequest& tolerance, RefineRoute route) {
  FitOptions options = optimal(1, Effort::balanced);
  options.tolerance = tolerance;
  options.route = route;
  options.between = false;
  const Stopwatch watch;
  const FitResult result = fit_surface(points, options);
  return figures_of(result, watch);
}

/// Files of samples/ and of the folder that KNOTFIT_DATA names.
struct FileSet {
  std::string file, percent;
  double share;
};
const std::vector<FileSet> kFiles = {
    {"face.uv.csv", "1", 1},          {"jacksboro.asc", "5", 0.995},  {"deepdrawing.uv.csv", "1", 1},
    {"mask.uv.csv", "1", 1},          {"three_peaks.uv.csv", "1", 1}, {"blade_patch.uv.csv", "1", 1},
    {"blade_patch.uv.csv", "0.1", 1}, {"mountain.uv.csv", "1", 1},    {"boulder_srtm.asc", "5", 0.995}};

Figures file_by_route(const FileSet& set, RefineRoute route) {
  const char* folder = std::getenv("KNOTFIT_DATA");
  std::string path = KNOTFIT_SAMPLES "/" + set.file;
  if (!std::filesystem::exists(path) && folder) path = std::string(folder) + "/" + set.file;
  if (!std::filesystem::exists(path)) return {{"missing", set.file}};
  const SourceData source = read_data(path);
  const ParameterizedPoints points = std::holds_alternative<Raster>(source.content)
                                         ? parameterize_height_field(std::get<Raster>(source.content))
                                         : parameterize_given(std::get<PointTable>(source.content));
  ToleranceRequest tolerance{.value = std::stod(set.percent), .relative = true};
  if (set.share < 1) tolerance.measure = ErrorMeasure::percentile, tolerance.share = set.share;
  return by_route(points, tolerance, route);
}

/// With oblique parameters, found and tried beside the plain ones.
Figures oblique(const Data& data) {
  const double tolerance = 1e-3 * data.diagonal;
  const Stopwatch watch;
  const ShearedFit fit = fit_sheared(data.points, optimal(tolerance, Effort::balanced));
  Figures figures = figures_of(fit.result, watch);
  figures["shear_u"] = fit.result.map.shear_u;
  figures["shear_v"] = fit.result.map.shear_v;
  figures["between"] = fit.result.between.between.value_or(0) / tolerance;
  figures["bound"] = fit.result.between.bound.value_or(0) / tolerance;
  return figures;
}

const std::vector<std::pair<std::string, RefineRoute>> kRoutes = {{"insert", RefineRoute::insert},
                                                                  {"search", RefineRoute::search}};

}  // namespace

std::vector<Row> tolerance_rows() {
  std::vector<Row> rows;
  for (const auto& [word, effort] : kEfforts)
    for (const std::string& name : test::synthetic_names())
      for (int seed : {1, 2, 3, 11, 12})
        rows.push_back({{"tolerance", name, word, std::to_string(seed)}, [=, effort = effort] {
                          return guarded(make_data(name, 10000, static_cast<std::uint64_t>(seed)), effort);
                        }});
  return rows;
}

std::vector<Row> hostile_rows() {
  std::vector<Row> rows;
  for (const std::string name : {"franke", "ridge"})
    for (Variant variant : {Variant::hole, Variant::clusters, Variant::noise})
      for (const auto& [word, effort] : kEfforts)
        for (int seed : {1, 2})
          if (effort != Effort::fast)
            rows.push_back(
                {{"hostile", name, name_of(variant), word, std::to_string(seed)}, [=, effort = effort] {
                   return guarded(make_data(name, 10000, static_cast<std::uint64_t>(seed), variant), effort);
                 }});
  return rows;
}

std::vector<Row> time_rows() {
  std::vector<Row> rows;
  for (const std::string& name : test::synthetic_names())
    for (bool guard : {false, true})
      for (int run : {1, 2, 3})
        rows.push_back({{"time", name, guard ? "guard" : "plain", std::to_string(run)},
                        [=] { return search_alone(make_data(name, 10000, 1), guard); }});
  return rows;
}

std::vector<Row> rms_rows() {
  std::vector<Row> rows;
  for (const std::string name : {"franke", "torus"})
    for (const auto& [share_word, share] : {std::pair{"1e-4", 1e-4}, {"1e-5", 1e-5}})
      for (const auto& [word, effort] : kEfforts)
        for (bool guard : {true, false})
          for (int seed : {1, 2, 3})
            if (effort != Effort::fast)
              rows.push_back(
                  {{"rms", name, share_word, word, guard ? "guard" : "plain", std::to_string(seed)},
                   [=, share = share, effort = effort] {
                     return to_rms(name, share, effort, guard, static_cast<std::uint64_t>(seed));
                   }});
  return rows;
}

std::vector<Row> sweep_rows() {
  std::vector<Row> rows;
  for (const std::string& name : test::synthetic_names())
    for (int step = 0; step < 40; ++step)
      rows.push_back({{"sweep", name, std::to_string(step)}, [=] { return one_of_sweep(name, step); }});
  return rows;
}

std::vector<Row> insertion_rows() {
  std::vector<Row> rows;
  for (const std::string& name : test::synthetic_names())
    for (const auto& [word, route] : kRoutes)
      for (int seed : {1, 2, 3})
        rows.push_back({{"insertion", name, word, std::to_string(seed)}, [=, route = route] {
                          const Data data = make_data(name, 10000, static_cast<std::uint64_t>(seed));
                          return by_route(data.points, {.value = 1e-3 * data.diagonal}, route);
                        }});
  for (const FileSet& set : kFiles)
    for (const auto& [word, route] : kRoutes)
      rows.push_back({{"insertion", set.file, set.percent + "%", word},
                      [set, route = route] { return file_by_route(set, route); }});
  return rows;
}

std::vector<Row> shear_rows() {
  std::vector<Row> rows;
  for (const std::string name : {"franke", "peaks", "step", "ridge"})
    for (int seed : {1, 2, 3})
      rows.push_back({{"shear", name, std::to_string(seed)},
                      [=] { return oblique(make_data(name, 10000, static_cast<std::uint64_t>(seed))); }});
  return rows;
}

std::vector<Row> guard_cost_rows() {
  std::vector<Row> rows;
  for (const std::string& name : test::synthetic_names())
    for (bool guard : {false, true})
      rows.push_back({{"guard", name, guard ? "with" : "without"},
                      [=] { return search_alone(make_data(name, 100000, 1), guard); }});
  return rows;
}

}  // namespace knotfit::bench
