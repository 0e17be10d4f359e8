#include "compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/version.h"
#include "outputs.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

std::string file_name(const CompareRow& row) {
  std::string name = row.method + "-" + asked_text(row);
  for (char& c : name)
    if (c == ':') c = '-';
  std::erase(name, '%');
  return name;
}

/// A field of CSV: quoted where it must be [RFC 4180].
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string number_or_nothing(bool there, double x) {
  return there && std::isfinite(x) ? fmt::format("{}", x) : "";
}

Json json_row(const CompareRow& row) {
  const FitResult& r = row.result;
  Json j = {{"method", row.method}, {"asked", asked_text(row)}};
  if (row.fitted) {
    const bool measured = r.between.measured;
    j["size"] = {r.surface.size_u(), r.surface.size_v()};
    j["control_points"] = r.surface.control_point_count();
    j["rms"] = number(r.error.rms);
    j["max"] = number(r.error.max);
    j["between"] = measured ? number(r.between.between.value_or(NAN)) : Json(nullptr);
    j["bound"] = measured ? number(r.between.bound.value_or(NAN)) : Json(nullptr);
    j["thin"] = measured ? number(r.between.thin) : Json(nullptr);
    j["status"] = to_string(r.status);
    j["reached"] = row.tolerance.value > 0 ? Json(r.reached) : Json(nullptr);
    j["knots"] = {{"u", r.surface.knots_u().interior()}, {"v", r.surface.knots_v().interior()}};
    j["notes"] = r.notes;
    j["surface"] = "surfaces/" + file_name(row) + ".json";
  } else {
    j["status"] = "failed";
    j["failure"] = row.failure;
  }
  j["fits"] = r.fits;
  j["seconds"] = number(row.seconds);
  return j;
}

}  // namespace

std::string asked_text(const CompareRow& row) {
  if (row.asked_u > 0) return fmt::format("{}x{}", row.asked_u, row.asked_v);
  return to_text(ToleranceValue{row.tolerance.value, row.tolerance.relative});
}

std::string compare_table(const std::vector<CompareRow>& rows) {
  std::size_t method = 6, asked = 5;
  for (const CompareRow& row : rows) {
    method = std::max(method, row.method.size());
    asked = std::max(asked, asked_text(row).size());
  }
  std::string text =
      fmt::format("{:<{}}  {:<{}}  {:>9}  {:>6}  {:>10}  {:>10}  {:>10}  {:>8}  {:>7}\n", "method", method,
                  "asked", asked, "size", "points", "rms", "max", "between", "seconds", "fits");
  for (const CompareRow& row : rows) {
    const FitResult& r = row.result;
    text += fmt::format("{:<{}}  {:<{}}  ", row.method, method, asked_text(row), asked);
    if (!row.fitted) {
      text += "failed: " + row.failure + "\n";
      continue;
    }
    text +=
        fmt::format("{:>9}  {:>6}  {:>10.4g}  {:>10.4g}  {:>10}  {:>8.2f}  {:>7}{}\n",
                    fmt::format("{}x{}", r.surface.size_u(), r.surface.size_v()),
                    r.surface.control_point_count(), r.error.rms, r.error.max,
                    r.between.between ? fmt::format("{:.4g}", *r.between.between) : "-", row.seconds, r.fits,
                    row.tolerance.value > 0 && !r.reached ? fmt::format("  {}", to_string(r.status)) : "");
  }
  return text;
}

std::string compare_csv(const std::vector<CompareRow>& rows) {
  std::string text =
      "method,asked,size_u,size_v,control_points,rms,max,between,bound,thin,seconds,fits,status,failure\n";
  for (const CompareRow& row : rows) {
    const FitResult& r = row.result;
    const bool f = row.fitted, b = f && r.between.measured, promised = b && r.between.between;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", field(row.method), asked_text(row),
        f ? fmt::format("{}", r.surface.size_u()) : "", f ? fmt::format("{}", r.surface.size_v()) : "",
        f ? fmt::format("{}", r.surface.control_point_count()) : "", number_or_nothing(f, r.error.rms),
        number_or_nothing(f, r.error.max), number_or_nothing(promised, r.between.between.value_or(0)),
        number_or_nothing(promised, r.between.bound.value_or(0)), number_or_nothing(b, r.between.thin),
        number_or_nothing(true, row.seconds), r.fits, f ? to_string(r.status) : "failed", field(row.failure));
  }
  return text;
}

std::string compare_json(const std::vector<CompareRow>& rows, const FitInput& input, bool stopped) {
  Json list = Json::array();
  for (const CompareRow& row : rows) list.push_back(json_row(row));
  Json j = {{"input", input.summary.path},
            {"points", input.summary.points},
            {"dimension", input.points.dimension},
            {"stopped", stopped},
            {"rows", list},
            {"notes", input.summary.reading.notes},
            {"version", version()}};
  if (const Reading& reading = input.summary.reading; !reading.columns.empty()) {
    j["columns"] = reading.columns;
    j["columns_from"] = reading.from;
  }
  return j.dump();
}

CompareFolder::CompareFolder(std::string path, bool force) : path_(std::move(path)) {
  std::error_code error;
  if (fs::exists(path_, error) && !fs::is_directory(path_, error))
    throw FileError(path_, "is a file; -o of a comparison names a folder");
  for (const char* folder : {"", "surfaces", "maps"}) {
    const fs::path made = fs::path(path_) / folder;
    fs::create_directory(*folder ? made : fs::path(path_), error);
    if (!fs::is_directory(made))
      throw FileError(path_, "the folder cannot be made: does the one above it exist?");
  }
  check_writable(file("table.json"), force);
  check_writable(file("table.csv"), force);
}

std::string CompareFolder::file(const std::string& name) const {
  return (fs::path(path_) / name).string();
}

void CompareFolder::write(const std::string& name, const std::string& text) const {
  write_text_file(file(name), true, text);
}

void CompareFolder::add(const CompareRow& row, const FitInput& input, const std::string& options) {
  rows_.push_back(row);
  if (row.fitted)
    write("surfaces/" + file_name(row) + ".json", to_json({.surface = row.result.surface,
                                                           .map = row.result.map,
                                                           .height_field = row.result.height_field,
                                                           .options = options,
                                                           .result = ""}));
  write("table.csv", compare_csv(rows_));
  write("table.json", compare_json(rows_, input, false) + "\n");
}

std::vector<ErrorSeries> error_series(const std::vector<CompareRow>& rows) {
  std::vector<ErrorSeries> series;
  for (const CompareRow& row : rows) {
    if (!row.fitted || !(row.result.error.rms > 0)) continue;
    auto of_method = std::find_if(series.begin(), series.end(),
                                  [&](const ErrorSeries& s) { return s.name == row.method; });
    if (of_method == series.end()) {
      series.emplace_back().name = row.method;
      of_method = series.end() - 1;
    }
    of_method->points.push_back(
        {static_cast<double>(row.result.surface.control_point_count()), row.result.error.rms});
  }
  return series;
}

void CompareFolder::draw(const FitInput& input) const {
  const std::string name = fs::path(input.summary.path).filename().string();
  std::map<std::string, std::vector<const CompareRow*>> by_size;
  for (const CompareRow& row : rows_)
    if (row.fitted) by_size[asked_text(row)].push_back(&row);
  const std::vector<ErrorSeries> series = error_series(rows_);
  for (const char* extension : {".svg", ".png"}) {
    if (!series.empty())
      write(std::string("errors") + extension,
            draw_error_plot(series, name + ": RMS error against control points", "RMS error", extension));
    for (const auto& [size, rows] : by_size) {
      std::vector<ComparedSurface> panels;
      for (const CompareRow* row : rows)
        panels.push_back({.name = row->method,
                          .remark = fmt::format("{}RMS {:.3g}, max {:.3g}",
                                                row->tolerance.value > 0
                                                    ? fmt::format("{} x {}, ", row->result.surface.size_u(),
                                                                  row->result.surface.size_v())
                                                    : "",
                                                row->result.error.rms, row->result.error.max),
                          .surface = &row->result.surface,
                          .errors = row->result.errors});
      const double range = error_range(panels);
      std::string plain = size;
      std::erase(plain, '%');
      write("maps-" + plain + extension,
            draw_error_maps(panels, input.points, range, fmt::format("{}: knots and errors, {}", name, size),
                            extension));
      for (std::size_t k = 0; k < panels.size(); ++k)
        write("maps/" + file_name(*rows[k]) + extension,
              draw_error_maps({panels[k]}, input.points, range,
                              fmt::format("{}: {}, {}", name, panels[k].name, size), extension,
                              {.width = 900, .height = 1000}));
    }
  }
}

}  // namespace knotfit::tool
