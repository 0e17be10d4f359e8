#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "base/place_text.h"
#include "fit/error_measure.h"
#include "fit_report.h"
#include "outputs.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

// "0.00123 (0.12 %)": with the share of the diagonal where there is one.
std::string error_text(double error, double diagonal) {
  if (!std::isfinite(error)) return "none";
  if (!(diagonal > 0)) return fmt::format("{:.4g}", error);
  return fmt::format("{:.4g} ({:.3g} %)", error, 100 * error / diagonal);
}

std::string measure_text(const FitChoices& choices) {
  const MeasureValue m = choices.measure.value_or(MeasureValue{});
  return fmt::format(fmt::runtime(row_of(m.measure).where), 100 * m.share);
}

std::string memory_text(long long bytes) {
  const double mb = static_cast<double>(bytes) / 1e6;
  return mb < 1000 ? fmt::format("{:.0f} MB", mb) : fmt::format("{:.2f} GB", mb / 1000);
}

std::string input_line(const FitReport& r) {
  const InputSummary& s = r.input.summary;
  std::string line = fmt::format("{}: {} points", input_name(s.path), s.points);
  if (s.holes > 0) line += fmt::format(", {} holes", s.holes);
  if (s.duplicates > 0) line += fmt::format(", {} dropped (equal parameters)", s.duplicates);
  line += r.result.height_field ? ", height field, range of heights" : ", diagonal";
  line += fmt::format(" {:.6g}\n", r.result.diagonal);
  line += columns_to_text(s.reading);
  return r.input.mesh ? line + mesh_to_text(*r.input.mesh) : line;
}

std::string worst_place(const FitReport& r) {
  const ErrorSummary& e = r.result.error;
  const ParameterizedPoints& points = r.input.points;
  if (e.worst < 0 || e.worst >= points.size()) return "";
  const ParameterMap& map = r.result.map;
  const bool from_text = !points.source.empty() && !r.input.raster;
  const Index line = points.source.empty() ? e.worst + 1 : points.source[e.worst];
  const auto [a, b] = map.from_uv(e.worst_u, e.worst_v);
  const auto shown = [&](double x) { return map.identity() ? fmt::format("{:.6g}", x) : place_text(x); };
  return fmt::format("at {} {}, {} = {}, {} = {}", from_text ? "line" : "point", line, map.name_u, shown(a),
                     map.name_v, shown(b));
}

std::string tolerance_line(const FitReport& r) {
  if (!r.choices.tolerance) return "tolerance: none asked\n";
  const ToleranceValue& asked = *r.choices.tolerance;
  std::string line = "tolerance: " + to_text(asked);
  if (r.default_tolerance) line += " (the default)";
  if (asked.relative)
    line += fmt::format(" = {:.4g}", r.result.tolerance);
  else if (r.result.diagonal > 0)
    line += fmt::format(" = {:.3g} %", 100 * asked.value / r.result.diagonal);
  line += " " + measure_text(r.choices);
  line += r.result.reached ? ": reached"
          : r.result.measured <= r.result.tolerance
              ? fmt::format(": NOT reached (held at the points: {:.4g}; the surface swings between them)",
                            r.result.measured)
              : fmt::format(": NOT reached ({:.4g})", r.result.measured);
  if (const double share = share_within(r.result); share < 1)
    line += fmt::format("; {:.4g} % of the points are within it", 100 * share);
  return line + "\n";
}

std::string correction_lines(const FitReport& r) {
  if (r.corrected == nullptr) return "";
  const MeshFit& fit = *r.corrected;
  const DistanceSummary& v = fit.correction.distance;
  const FoldReport& folds = fit.correction.folds;
  const double diagonal = r.result.diagonal;
  std::string text = fmt::format(
      "corrected in {} rounds: errors are distances to the surface, signed mean {:.3g}, standard deviation "
      "{:.4g}\n"
      "       at the parameters max {}, rms {}\n",
      fit.correction.rounds.size() - 1, v.signed_mean, v.deviation,
      error_text(fit.at_parameters.max, diagonal), error_text(fit.at_parameters.rms, diagonal));
  if (fit.to_mesh.count > 0)
    text += fmt::format("surface to mesh: max {}, rms {}\n", error_text(fit.to_mesh.max, diagonal),
                        error_text(fit.to_mesh.rms, diagonal));
  return text +
         fmt::format(
             "folds: {:.2g} % of the square{}, {} triangles turned over\n"
             "       normals {:.3g} degrees from the blurred mesh's, rms\n",
             100 * folds.blurred,
             folds.pleats > 0 ? fmt::format(", narrower than a span {:.2g} %", 100 * folds.pleats) : "",
             folds.flipped, folds.normal_angle);
}

std::string between_line(const BetweenReport& b, double diagonal) {
  if (!b.measured) return "between the points: not measured\n";
  if (!b.between)
    return fmt::format(
        "between the points: nothing promised; too thin to promise anything: {:.3g} % of the domain\n",
        100 * b.thin);
  return fmt::format(
      "between the points: {}, bound {}; too thin to promise anything: {:.3g} % of the domain\n",
      error_text(*b.between, diagonal), error_text(*b.bound, diagonal), 100 * b.thin);
}

// What optimised knots saved.
std::string savings_line(const FitResult& r) {
  const Comparison &u = r.against_uniform, &e = r.against_error_model;
  if (!(u.error > 0) || !(e.error > 0) || !(r.measured > 0)) return "";
  return fmt::format(
      "knots: at this size uniform ones err {:.3g} times as much, the error model's {:.3g} times; they would "
      "need about {:.0f} and {:.0f} control points\n",
      u.error / r.measured, e.error / r.measured, u.control_points, e.control_points);
}

}  // namespace

double share_within(const FitResult& result) {
  if (result.errors.empty()) return 0;
  const auto within = std::count_if(result.errors.begin(), result.errors.end(),
                                    [&](double e) { return e <= result.tolerance; });
  return static_cast<double>(within) / static_cast<double>(result.errors.size());
}

std::string verdict(const FitReport& r) {
  if (!r.choices.tolerance)
    return r.result.swings.swings ? "a fixed size that swings between the points" : "a fixed size";
  return fmt::format("{} {}: {}", to_text(*r.choices.tolerance), measure_text(r.choices),
                     r.result.reached                    ? "reached"
                     : r.result.status == Status::swings ? "the surface swings between the points"
                                                         : "not reached");
}

std::string report_to_text(const FitReport& r) {
  const FitResult& result = r.result;
  const Surface& s = result.surface;
  const double diagonal = result.diagonal;
  // What makes a surface useless stands before all figures.
  std::string text = result.swings.swings ? result.notes.front() + "\n" : "";
  text += input_line(r);
  if (!s.empty()) {
    text += fmt::format("surface: {} x {} = {} control points, degree {} x {}, knots by {}{}\n", s.size_u(),
                        s.size_v(), s.control_point_count(), s.degree_u(), s.degree_v(), result.method,
                        result.sample > 0 ? fmt::format(" on a sample of {} points", result.sample) : "");
    const ErrorSummary& e = result.error;
    text += fmt::format("error: max {} {}\n", error_text(e.max, diagonal), worst_place(r));
    text +=
        fmt::format("       rms {}, mean {:.4g}, median {:.4g}, 95 % {:.4g}, 99 % {:.4g}, 99.5 % {:.4g}\n",
                    error_text(e.rms, diagonal), e.mean, e.median, e.p95, e.p99, e.p995);
    text += correction_lines(r);
    text += tolerance_line(r);
    text += between_line(result.between, diagonal);
    text += savings_line(result);
  }
  text += fmt::format("status: {}: {}\n", to_string(result.status), result.message);
  text += fmt::format("{} fits, {:.2f} s, {}", result.fits, r.seconds, memory_text(r.peak_memory_bytes));
  if (result.condition > 0) text += fmt::format(", condition {:.2g}", result.condition);
  text += "\n";
  text += notes_to_text(r.input.summary.reading);
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  text += wrote(r.outputs);
  return text;
}

long long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<long long>(usage.ru_maxrss) * 1024;  // Linux counts in kilobytes
}

}  // namespace knotfit::tool
