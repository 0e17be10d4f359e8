#include "curve_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "fit/error_measure.h"
#include "knotfit/curve_io.h"
#include "knotfit/curve_picture.h"
#include "knotfit/exceptions.h"
#include "knotfit/version.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

void add_columns(Json& j, const Reading& reading) {
  if (reading.columns.empty()) return;
  j["columns"] = reading.columns;
  j["columns_from"] = reading.from;
}

Json swings_of(const SwingReport& s) {
  if (!s.measured) return nullptr;
  return {{"largest", number(s.largest)},
          {"distance", number(s.distance)},
          {"t", s.worst_u},
          {"in_gap", s.in_gap},
          {"places", s.places},
          {"above_3", s.above},
          {"beyond_box", number(s.beyond_box)}};
}

/// Nothing that a second run changes.
Json outcome(const CurveReport& r) {
  const CurveFitResult& f = r.result;
  const ErrorSummary& e = f.error;
  Json worst = nullptr;
  if (e.worst >= 0)
    worst = {{"index", e.worst},
             {"line", r.points.source.empty() ? e.worst + 1 : r.points.source[e.worst]},
             {"t", number(f.t[e.worst])}};
  Json tolerance = nullptr;
  if (f.tolerance > 0) {
    tolerance = {{"value", f.tolerance}, {"measure", row_of(f.asked.measure).name}, {"share", f.asked.share}};
  }
  std::vector<std::string> notes = r.reading.notes;
  notes.insert(notes.end(), f.notes.begin(), f.notes.end());
  return {{"control_points", f.control_points},
          {"degree", f.curve.degree()},
          {"closed", f.closed},
          {"dimension", f.curve.dimension()},
          {"knots", f.knots},
          {"error",
           {{"rms", number(e.rms)},
            {"max", number(e.max)},
            {"mean", number(e.mean)},
            {"median", number(e.median)},
            {"p95", number(e.p95)},
            {"worst", worst}}},
          {"tolerance", tolerance},
          {"measured", number(f.measured)},
          {"swings", swings_of(f.swings)},
          {"reached", f.reached},
          {"status", to_string(f.status)},
          {"message", f.message},
          {"method", f.method},
          {"fits", f.fits},
          {"noise", number(f.noise)},
          {"diagonal", number(f.diagonal)},
          {"points", r.points.size()},
          {"left_out", r.reading.left_out},
          {"notes", notes}};
}

std::string verdict(const CurveFitResult& f) {
  return fmt::format("{}{} control points, RMS {:.3g}, max {:.3g}",
                     f.swings.swings ? "swings between the points: " : "", f.control_points, f.error.rms,
                     f.error.max);
}

void write_points(std::ostream& out, const CurveReport& r) {
  const int d = r.points.dimension;
  out << (r.points.function ? "t,x,y" : d == 2 ? "t,x,y" : "t,x,y,z") << ",error\n";
  for (Index k = 0; k < r.points.size(); ++k) {
    std::string line = fmt::format("{}", r.result.t[k]);
    if (r.points.function)
      line += fmt::format(",{}", r.points.x0 + r.points.t[k] * (r.points.x1 - r.points.x0));
    for (int e = 0; e < d; ++e) line += fmt::format(",{}", r.points.value(k)[e]);
    out << line << fmt::format(",{}\n", r.result.errors[k]);
  }
}

CurvePictureInput picture_of(const CurveReport& r) {
  CurvePictureInput p;
  p.curve = &r.result.curve;
  p.points = r.points.values;
  p.t = r.result.t;
  p.errors = r.result.errors;
  p.title = std::filesystem::path(r.arguments.input).filename().string() + ": " + verdict(r.result);
  p.subtitle = fmt::format("degree {}, knots by {}{}", r.result.curve.degree(), r.result.method,
                           r.result.closed ? ", closed" : "");
  p.x0 = r.points.x0;
  p.x1 = r.points.x1;
  return p;
}

}  // namespace

CurveDocument document_of(const CurveFitResult& result, const CurvePoints& points) {
  CurveDocument document;
  document.curve = result.curve;
  document.closed = result.closed;
  document.function = points.function;
  document.x0 = points.x0;
  document.x1 = points.x1;
  return document;
}

std::string curve_to_json(const CurveReport& r) {
  Json j = outcome(r);
  Json tried = Json::array();
  for (const SizeTried& t : r.result.tried)
    tried.push_back({{"control_points", t.size_u}, {"error", number(t.error)}, {"holds", t.holds}});
  j["tried"] = tried;
  j["input"] = r.arguments.input;
  add_columns(j, r.reading);
  j["seconds"] = number(r.seconds);
  j["outputs"] = r.outputs;
  j["version"] = version();
  return j.dump();
}

std::string curve_to_text(const CurveReport& r) {
  const CurveFitResult& f = r.result;
  // What makes a curve useless stands before all figures.
  std::string text = f.swings.swings ? f.notes.front() + "\n" : "";
  text += fmt::format("{}: {} points, {}{}, diagonal {:.6g}\n", input_name(r.arguments.input),
                      r.points.size(), f.closed ? "closed, " : "",
                      r.points.function         ? "y over x"
                      : r.points.dimension == 2 ? "planar"
                                                : "in space",
                      f.diagonal);
  text += columns_to_text(r.reading);
  text += fmt::format("curve: {} control points, degree {}, knots by {}\n", f.control_points,
                      f.curve.degree(), f.method);
  const auto share = [&](double x) {
    return f.diagonal > 0 ? fmt::format("{:.4g} ({:.3g} %)", x, 100 * x / f.diagonal)
                          : fmt::format("{:.4g}", x);
  };
  text += fmt::format("error: max {}, rms {}, median {:.4g}, 95 % {:.4g}\n", share(f.error.max),
                      share(f.error.rms), f.error.median, f.error.p95);
  text += f.tolerance > 0
              ? fmt::format("tolerance: {:.4g}: {}\n", f.tolerance,
                            f.reached ? "reached"
                            : f.measured <= f.tolerance
                                ? "NOT reached (held at the points; the curve swings between them)"
                                : "NOT reached")
              : std::string("tolerance: none asked\n");
  text +=
      fmt::format("status: {}: {}\n{} fits, {:.2f} s\n", to_string(f.status), f.message, f.fits, r.seconds);
  text += notes_to_text(r.reading);
  for (std::size_t i = f.swings.swings ? 1 : 0; i < f.notes.size(); ++i) text += "note: " + f.notes[i] + "\n";
  return text + wrote(r.outputs);
}

void check_curve_output(const OutputFile& file) {
  if (file.kind == OutputKind::raster || file.kind == OutputKind::mesh)
    throw InvalidInput(
        fmt::format("{}: no curve is written as {}; outputs are .json, .csv, .svg, .png, .pdf, "
                    ".step, .stp, .igs, .iges",
                    file.path, file.extension));
}

void write_curve_output(const OutputFile& file, const CurveReport& r) {
  const bool force = r.arguments.output.force;
  switch (file.kind) {
    case OutputKind::surface: {
      CurveDocument document = document_of(r.result, r.points);
      document.result = outcome(r).dump();
      return write_text_file(file.path, force, to_json(document));
    }
    case OutputKind::table:
      return write_file(file.path, force, [&](std::ostream& out) { write_points(out, r); });
    case OutputKind::picture:
      return write_text_file(file.path, force, draw_curve_picture(picture_of(r), file.extension));
    case OutputKind::cad: {
      CadOptions options;
      const CadChoices& cad = r.arguments.choices.cad;
      options.format = file.extension == ".igs" || file.extension == ".iges"
                           ? CadFormat::iges
                           : cad.schema.value_or(CadFormat::step_ap242);
      options.unit = cad.unit.value_or(CadUnit::millimetre);
      options.name = cad.name.value_or(std::filesystem::path(file.path).stem().string());
      try {
        return write_cad_curve(file.path, curve_in_space(document_of(r.result, r.points)), options, force);
      } catch (const InvalidInput& e) {
        throw InvalidInput(file.path + ": " + e.what());
      }
    }
    default:
      check_curve_output(file);
  }
}

std::string curve_table(const std::vector<CurveRow>& rows) {
  std::size_t width = 6;
  for (const CurveRow& row : rows) width = std::max(width, row.method.size());
  std::string text = fmt::format("{:<{}}  {:>6}  {:>10}  {:>10}  {:>8}  {:>7}\n", "method", width, "points",
                                 "rms", "max", "seconds", "fits");
  for (const CurveRow& row : rows) {
    const CurveFitResult& f = row.result;
    if (!row.failure.empty())
      text += fmt::format("{:<{}}  failed: {}\n", row.method, width, row.failure);
    else
      text += fmt::format("{:<{}}  {:>6}  {:>10.4g}  {:>10.4g}  {:>8.2f}  {:>7}{}\n", row.method, width,
                          f.control_points, f.error.rms, f.error.max, row.seconds, f.fits,
                          f.tolerance > 0 && !f.reached ? fmt::format("  {}", to_string(f.status)) : "");
  }
  return text;
}

std::string curve_rows_json(const std::vector<CurveRow>& rows, const Arguments& arguments,
                            const Reading& reading, bool stopped) {
  Json list = Json::array();
  for (const CurveRow& row : rows) {
    const CurveFitResult& f = row.result;
    Json j = {{"method", row.method}};
    if (!row.failure.empty()) {
      j["status"] = "failed";
      j["failure"] = row.failure;
    } else {
      j["control_points"] = f.control_points;
      j["rms"] = number(f.error.rms);
      j["max"] = number(f.error.max);
      j["status"] = to_string(f.status);
      j["knots"] = f.knots;
      j["notes"] = f.notes;
    }
    j["fits"] = f.fits;
    j["seconds"] = number(row.seconds);
    list.push_back(j);
  }
  Json j = {{"input", arguments.input},
            {"stopped", stopped},
            {"rows", list},
            {"notes", reading.notes},
            {"version", version()}};
  add_columns(j, reading);
  return j.dump();
}

}  // namespace knotfit::tool
