#include "knotfit/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <tuple>

#include "knotfit/exceptions.h"
#include "pipeline/request.h"
namespace knotfit {
namespace {

constexpr std::string_view kGiven = "given";  ///< FitOptions::user_features

bool by_given_features(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon != std::string_view::npos && name.substr(colon + 1) == kGiven;
}

std::vector<std::string> wanted_methods(const CompareOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const std::string& asked : options.methods) {
    if (asked != "all") {
      split_method(asked, options.fit.feature);
      if (by_given_features(asked) && options.fit.user_features.empty())
        throw InvalidInput(fmt::format("'{}' needs a feature measure of your own, and there is none", asked));
      add(asked);
      continue;
    }
    for (const PlacementMethod& m : placement_methods()) {
      if (m.name != "criterion") {
        add(std::string(m.name));
        continue;
      }
      for (const FeatureMeasureInfo& measure : feature_measures())
        add(fmt::format("criterion:{}", measure.name));
      if (!options.fit.user_features.empty()) add(fmt::format("criterion:{}", kGiven));
    }
  }
  return names;
}

}  // namespace

std::pair<std::string, FeatureMeasure> split_method(std::string_view name, FeatureMeasure otherwise) {
  const std::size_t colon = name.find(':');
  const std::string_view method = name.substr(0, colon);
  std::string known;
  bool there = false;
  for (const PlacementMethod& m : placement_methods()) {
    there |= m.name == method;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", m.name);
  }
  if (!there)
    throw InvalidInput(fmt::format("there is no placement method '{}'; there are {}", method, known));
  if (colon == std::string_view::npos) return {std::string(method), otherwise};
  const std::string_view measure = name.substr(colon + 1);
  if (measure == kGiven) return {std::string(method), otherwise};
  std::string measures;
  for (const FeatureMeasureInfo& m : feature_measures()) {
    if (measure == m.name) return {std::string(method), m.measure};
    measures += fmt::format("{}, ", m.name);
  }
  throw InvalidInput(
      fmt::format("there is no feature measure '{}'; there are {}{}", measure, measures, kGiven));
}

std::vector<CompareRow> comparison_rows(const CompareOptions& options) {
  if (options.sizes.empty() && options.tolerances.empty())
    throw InvalidInput("a comparison needs sizes or tolerances");
  const std::vector<std::string> methods = wanted_methods(options);
  if (methods.empty()) throw InvalidInput("a comparison needs methods");
  for (const auto& [u, v] : options.sizes) check_least_size(u, v, options.fit.degree_u, options.fit.degree_v);
  std::vector<CompareRow> rows;
  for (const auto& [u, v] : options.sizes)
    for (const std::string& method : methods) {
      CompareRow row;
      row.method = method;
      row.asked_u = u;
      row.asked_v = v;
      rows.push_back(std::move(row));
    }
  for (const ToleranceRequest& tolerance : options.tolerances)
    for (const std::string& method : methods) {
      CompareRow row;
      row.method = method;
      row.tolerance = tolerance;
      rows.push_back(std::move(row));
    }
  return rows;
}

std::vector<CompareRow> compare_methods(const ParameterizedPoints& points, const CompareOptions& options,
                                        const Control& control,
                                        const std::function<void(const CompareRow&)>& done) {
  std::vector<CompareRow> rows = comparison_rows(options);
  std::size_t ended = 0;
  for (CompareRow& row : rows) {
    if (control.stop.stop_requested()) break;
    if (control.progress)
      control.progress({.stage = row.method,
                        .fraction = static_cast<double>(ended) / static_cast<double>(rows.size()),
                        .size_u = row.asked_u,
                        .size_v = row.asked_v});
    FitOptions fit = options.fit;
    std::tie(fit.method, fit.feature) = split_method(row.method, options.fit.feature);
    // A measure that is named goes before one that is given for all.
    if (row.method.find(':') != std::string::npos && !by_given_features(row.method)) fit.user_features = {};
    fit.knots.reset();
    fit.control_points_u = row.asked_u;
    fit.control_points_v = row.asked_v;
    fit.tolerance.reset();
    if (row.tolerance.value > 0) fit.tolerance = row.tolerance;
    Control rest = control;
    rest.progress = {};  // the table's own progress is the one that counts
    const auto start = std::chrono::steady_clock::now();
    try {
      row.result = fit_surface(points, fit, rest);
      row.fitted = !row.result.surface.empty() && row.result.status != Status::failed;
      if (!row.fitted) row.failure = row.result.message;
    } catch (const InvalidInput& e) {
      row.failure = e.what();
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (control.stop.stop_requested()) break;  // cut short: not what the method does
    ++ended;
    if (done) done(row);
  }
  rows.resize(ended);
  return rows;
}

}  // namespace knotfit
