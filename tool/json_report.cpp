#include <cmath>
#include <nlohmann/json.hpp>

#include "fit/error_measure.h"
#include "fit_report.h"
#include "knotfit/version.h"
#include "options_json.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// What was not measured: null.
Json number(const std::optional<double>& x) {
  return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

Json swings_of(const FitResult& r) {
  const SwingReport& s = r.swings;
  if (!s.measured) return nullptr;
  const auto [a, b] = r.map.from_uv(s.worst_u, s.worst_v);
  return {{"largest", number(s.largest)},
          {"distance", number(s.distance)},
          {"u", s.worst_u},
          {"v", s.worst_v},
          {"place", {number(a), number(b)}},
          {"in_gap", s.in_gap},
          {"places", s.places},
          {"above_3", s.above},
          {"beyond_box", number(s.beyond_box)}};
}

// JSON has no infinity: null.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json error_of(const FitReport& r) {
  const ErrorSummary& e = r.result.error;
  const ParameterizedPoints& points = r.input.points;
  Json worst = nullptr;
  if (e.worst >= 0 && e.worst < points.size()) {
    const Index line = points.source.empty() ? e.worst + 1 : points.source[e.worst];
    worst = {{"index", e.worst}, {"line", line}, {"u", number(e.worst_u)}, {"v", number(e.worst_v)}};
    if (!r.result.map.identity()) {
      const auto [a, b] = r.result.map.from_uv(e.worst_u, e.worst_v);
      worst[r.result.map.name_u == "x" ? "x" : "given_u"] = number(a);
      worst[r.result.map.name_v == "y" ? "y" : "given_v"] = number(b);
    }
  }
  return {{"rms", number(e.rms)},       {"max", number(e.max)}, {"mean", number(e.mean)},
          {"median", number(e.median)}, {"p95", number(e.p95)}, {"p99", number(e.p99)},
          {"p995", number(e.p995)},     {"worst", worst}};
}

Json tolerance_of(const FitReport& r) {
  if (!r.choices.tolerance) return nullptr;
  const MeasureValue measure = r.choices.measure.value_or(MeasureValue{});
  return {{"value", number(r.result.tolerance)},
          {"asked", to_text(*r.choices.tolerance)},
          {"measure", row_of(measure.measure).name},
          {"share", measure.share},
          {"within", number(share_within(r.result))}};
}

Json input_of(const FitReport& r) {
  const InputSummary& s = r.input.summary;
  Json input = {{"path", s.path},
                {"format", s.format},
                {"points", s.points},
                {"holes", s.holes},
                {"duplicates", s.duplicates},
                {"welded", s.welded},
                {"dimension", r.input.points.dimension},
                {"height_field", r.result.height_field},
                {"diagonal", number(r.result.diagonal)}};
  if (r.input.mesh) input["mesh"] = Json::parse(mesh_to_json(*r.input.mesh));
  if (r.input.mesh && r.input.mesh->cloud) input["cloud"] = Json::parse(cloud_to_json(*r.input.mesh));
  if (const auto& raster = r.input.raster)
    input["grid"] = {{"columns", raster->columns}, {"rows", raster->rows},     {"x0", number(raster->x0)},
                     {"y0", number(raster->y0)},   {"dx", number(raster->dx)}, {"dy", number(raster->dy)}};
  return input;
}

// Of the reading first, then of the fit.
std::vector<std::string> notes_of(const FitReport& r) {
  std::vector<std::string> notes = r.input.summary.reading.notes;
  notes.insert(notes.end(), r.result.notes.begin(), r.result.notes.end());
  return notes;
}

void add_columns(Json& j, const Reading& reading) {
  if (reading.columns.empty()) return;
  j["columns"] = reading.columns;
  j["columns_from"] = reading.from;
}

// What a correction of the parameters left; null without one.
Json correction_of(const FitReport& r) {
  if (r.corrected == nullptr) return nullptr;
  const MeshFit& fit = *r.corrected;
  const DistanceSummary &v = fit.correction.distance, &back = fit.to_mesh;
  const FoldReport& folds = fit.correction.folds;
  Json places = Json::array();
  for (const FoldPlace& place : folds.places)
    places.push_back({{"u", place.u}, {"v", place.v}, {"share", place.share}});
  return {{"rounds", static_cast<Index>(fit.correction.rounds.size()) - 1},
          {"best_round", fit.correction.best_round},
          {"signed_mean", number(v.signed_mean)},
          {"standard_deviation", number(v.deviation)},
          {"error_at_parameters",
           {{"rms", number(fit.at_parameters.rms)}, {"max", number(fit.at_parameters.max)}}},
          {"off_foot", fit.off_foot},
          {"surface_to_mesh",
           back.count == 0
               ? Json(nullptr)
               : Json{{"rms", number(back.rms)}, {"max", number(back.max)}, {"p995", number(back.p995)}}},
          {"folds",
           {{"blurred", folds.blurred},
            {"raw", folds.raw},
            {"pleats", folds.pleats},
            {"flipped_triangles", folds.flipped},
            {"least_sine", number(folds.least_sine)},
            {"normal_angle", number(folds.normal_angle)},
            {"covered", folds.covered},
            {"places", std::move(places)}}}};
}

Json comparison_of(const Comparison& c) {
  if (!(c.error > 0)) return nullptr;
  return {{"error", number(c.error)}, {"control_points", number(std::round(c.control_points))}};
}

// The members that a second run repeats.
void add_outcome(Json& j, const FitReport& r) {
  const FitResult& result = r.result;
  const bool measured = result.between.measured;
  j["error"] = error_of(r);
  j["correction"] = correction_of(r);
  j["between"] = number(result.between.between);
  j["bound"] = number(result.between.bound);
  j["thin"] = measured ? number(result.between.thin) : Json(nullptr);
  j["swings"] = swings_of(result);
  j["tolerance"] = tolerance_of(r);
  j["measured"] = number(result.measured);
  j["reached"] = result.reached;
  j["status"] = to_string(result.status);
  j["message"] = result.message;
  j["method"] = result.method;
  j["condition"] = number(result.condition);
  j["noise"] = number(result.noise);
  j["fits"] = result.fits;
  j["least_squares"] = result.least_squares;
  j["fill_points"] = result.fill_points;
  j["sample"] = result.sample;
  j["against_uniform"] = comparison_of(result.against_uniform);
  j["against_error_model"] = comparison_of(result.against_error_model);
}

}  // namespace

std::string stored_result(const FitReport& r) {
  Json j;
  add_outcome(j, r);
  j["input"] = input_of(r);
  add_columns(j, r.input.summary.reading);
  j["notes"] = notes_of(r);
  return j.dump();
}

std::string report_to_json(const FitReport& r) {
  const Surface& s = r.result.surface;
  Json j;
  j["size"] = {s.empty() ? 0 : s.size_u(), s.empty() ? 0 : s.size_v()};
  j["control_points"] = s.empty() ? 0 : s.control_point_count();
  j["degree"] = {s.degree_u(), s.degree_v()};
  j["knots"] = {{"u", s.knots_u().knots()}, {"v", s.knots_v().knots()}};
  if (const ParameterMap& map = r.result.map; map.sheared())
    j["shear"] = {{"u", map.shear_u}, {"v", map.shear_v}};
  add_outcome(j, r);
  j["seconds"] = number(r.seconds);
  j["peak_memory_bytes"] = r.peak_memory_bytes;
  j["input"] = input_of(r);
  j["options"] = Json::parse(options_to_json(r.choices));
  add_columns(j, r.input.summary.reading);
  j["notes"] = notes_of(r);
  j["outputs"] = r.outputs;
  j["version"] = version();
  return j.dump();
}

}  // namespace knotfit::tool
