#include "options_json.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>

#include "knotfit/exceptions.h"
#include "knotfit/fit_surface.h"
#include "knotfit/knot_vector.h"
#include "mesh_outputs.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// One row of the table: an option's member, and both ways between it and its field.
struct Row {
  const char* name;
  std::function<bool(const FitChoices&)> given;
  std::function<Json(const FitChoices&)> get;          // of a field that is given
  std::function<void(FitChoices&, const Json&)> set;   // throws InvalidInput or Json::exception
  std::function<std::string(const FitChoices&)> text;  // "" for a default
};

template <class T>
using Field = std::optional<T> FitChoices::*;

template <class T>
Row row(const char* name, Field<T> field, std::function<Json(const T&)> get,
        std::function<T(const Json&)> set, std::function<std::string(const T&)> text) {
  return {name, [field](const FitChoices& c) { return (c.*field).has_value(); },
          [field, get](const FitChoices& c) { return get(*(c.*field)); },
          [field, set](FitChoices& c, const Json& j) { c.*field = set(j); },
          [field, text](const FitChoices& c) { return text(*(c.*field)); }};
}

// A name of a fixed list.
template <class E, std::size_t N>
Row named(const char* name, Field<E> field, const Named<E> (&table)[N], E usual, const char* option) {
  return row<E>(
      name, field, [&table](const E& e) { return Json(name_of(table, e)); },
      [&table](const Json& j) { return parse_named(table, j.get<std::string>()); },
      [&table, usual, option](const E& e) {
        return e == usual ? "" : fmt::format("{} {}", option, name_of(table, e));
      });
}

Row flag(const char* name, Field<bool> field, bool usual, const char* option) {
  return row<bool>(
      name, field, [](const bool& b) { return Json(b); }, [](const Json& j) { return j.get<bool>(); },
      [usual, option](const bool& b) { return b == usual ? std::string() : std::string(option); });
}

Row pair(const char* name, Field<IntegerPair> field, int least, IntegerPair usual, const char* option) {
  return row<IntegerPair>(
      name, field,
      [](const IntegerPair& p) {
        return Json{p.first, p.second};
      },
      [least](const Json& j) {
        const auto p = j.get<std::array<int, 2>>();
        return parse_pair(fmt::format("{}x{}", p[0], p[1]), least);
      },
      [usual, option](const IntegerPair& p) {
        if (p.first == usual.first && p.second == usual.second) return std::string();
        return fmt::format("{} {}x{}", option, p.first, p.second);
      });
}

template <class T>
Row count(const char* name, Field<T> field, T usual, const char* option) {
  return row<T>(
      name, field, [](const T& n) { return Json(n); },
      [](const Json& j) { return static_cast<T>(parse_count(j.dump(), 1)); },
      [usual, option](const T& n) { return n == usual ? "" : fmt::format("{} {}", option, n); });
}

Row number(const char* name, Field<double> field, double (*check)(std::string_view), double usual,
           const char* option) {
  return row<double>(
      name, field, [](const double& x) { return Json(x); },
      [check](const Json& j) { return check(fmt::format("{}", j.get<double>())); },
      [usual, option](const double& x) { return x == usual ? "" : fmt::format("{} {}", option, x); });
}

// An option of FitChoices::input.
template <class T>
Row input(const char* name, std::optional<T> InputOptions::*field,
          std::function<std::string(const T&)> text) {
  return {name, [field](const FitChoices& c) { return (c.input.*field).has_value(); },
          [field](const FitChoices& c) { return Json(*(c.input.*field)); },
          [field](FitChoices& c, const Json& j) { c.input.*field = j.get<T>(); },
          [field, text](const FitChoices& c) { return text(*(c.input.*field)); }};
}

// An option of FitChoices::cad.
template <class T>
Row cad(const char* name, std::optional<T> CadChoices::*field, std::function<Json(const T&)> get,
        std::function<T(const Json&)> set, std::function<std::string(const T&)> text) {
  return {name, [field](const FitChoices& c) { return (c.cad.*field).has_value(); },
          [field, get](const FitChoices& c) { return get(*(c.cad.*field)); },
          [field, set](FitChoices& c, const Json& j) { c.cad.*field = set(j); },
          [field, text](const FitChoices& c) { return text(*(c.cad.*field)); }};
}

template <class E, std::size_t N>
Row named_cad(const char* name, std::optional<E> CadChoices::*field, const Named<E> (&table)[N], E usual,
              const char* option) {
  return cad<E>(
      name, field, [&table](const E& e) { return Json(name_of(table, e)); },
      [&table](const Json& j) { return parse_named(table, j.get<std::string>()); },
      [&table, usual, option](const E& e) {
        return e == usual ? "" : fmt::format("{} {}", option, name_of(table, e));
      });
}

std::string join(std::span<const double> values) {
  return fmt::format("{}", fmt::join(values, ","));
}

// Knots are one choice with three members: the method's name, or "given" and both lists.
Row knots() {
  return {"knots", [](const FitChoices& c) { return c.knots.has_value(); },
          [](const FitChoices& c) -> Json {
            if (!c.knots->given) return c.knots->method;
            return Json{{"u", c.knots->given->u}, {"v", c.knots->given->v}};
          },
          [](FitChoices& c, const Json& j) {
            KnotSource source;
            if (j.is_string()) {
              source.method = j.get<std::string>();
            } else {
              const auto list = [&](const char* name) {
                return parse_knots(join(j.at(name).get<std::vector<double>>()));
              };
              source.given = InteriorKnots{list("u"), list("v")};
            }
            c.knots = source;
          },
          [](const FitChoices& c) {
            if (!c.knots->given)
              return c.knots->method == FitOptions{}.method ? "" : "--knots " + c.knots->method;
            const auto list = [](const std::vector<double>& k) { return k.empty() ? "none" : join(k); };
            return fmt::format("--knots-u {} --knots-v {}", list(c.knots->given->u), list(c.knots->given->v));
          }};
}

Row cell() {
  using Cell = std::pair<double, double>;
  return row<Cell>(
      "cell", &FitChoices::cell,
      [](const Cell& s) {
        return Json{s.first, s.second};
      },
      [](const Json& j) {
        const auto s = j.get<std::array<double, 2>>();
        return parse_cell(fmt::format("{}x{}", s[0], s[1]));
      },
      [](const Cell& s) { return fmt::format("--cell {}x{}", s.first, s.second); });
}

// The table: every option that shapes a result.
const std::vector<Row>& table() {
  static const std::vector<Row> rows = {
      row<ToleranceValue>(
          "tolerance", &FitChoices::tolerance, [](const ToleranceValue& t) { return Json(to_text(t)); },
          [](const Json& j) { return parse_tolerance(j.get<std::string>()); },
          [](const ToleranceValue& t) { return "--tol " + to_text(t); }),
      row<MeasureValue>(
          "measure", &FitChoices::measure, [](const MeasureValue& m) { return Json(to_text(m)); },
          [](const Json& j) { return parse_measure(j.get<std::string>()); },
          [](const MeasureValue& m) -> std::string {
            if (m.measure == ErrorMeasure::max) return "";
            return m.measure == ErrorMeasure::rms ? "--rms" : "--within " + to_text(m);
          }),
      pair("control_points", &FitChoices::control_points, 2, {0, 0}, "--control-points"),
      knots(),
      row<IntegerPair>(
          "degree", &FitChoices::degree,
          [](const IntegerPair& d) {
            return d.first == 0 ? Json("auto") : Json{d.first, d.second};
          },
          [](const Json& j) {
            if (j.is_string()) return parse_degree(j.get<std::string>());
            const auto d = j.get<std::array<int, 2>>();
            return parse_degree(fmt::format("{}x{}", d[0], d[1]));
          },
          [](const IntegerPair& d) {
            return d.first == 3 && d.second == 3 ? std::string() : "--degree " + degree_text(d);
          }),
      row<ShearChoice>(
          "shear", &FitChoices::shear, [](const ShearChoice& s) { return Json(shear_text(s)); },
          [](const Json& j) { return parse_shear(j.get<std::string>()); },
          [](const ShearChoice& s) { return s.asked() ? "--shear " + shear_text(s) : ""; }),
      named("refine", &FitChoices::refine, kRoutes, RefineRoute::search, "--refine"),
      named("effort", &FitChoices::effort, kEfforts, Effort::balanced, "--effort"),
      flag("guard", &FitChoices::guard, true, "--guard off"),
      count<long long>("max_control_points", &FitChoices::max_control_points, 0, "--max-control-points"),
      count<long>("max_fits", &FitChoices::max_fits, 0, "--max-fits"),
      number("time_limit", &FitChoices::time_limit, parse_positive, 0, "--time-limit"),
      named("feature", &FitChoices::feature, kFeatures, FeatureMeasure::hessian, "--feature"),
      row<std::string>(
          "feature_file", &FitChoices::feature_file, [](const std::string& t) { return Json(t); },
          [](const Json& j) { return j.get<std::string>(); },
          [](const std::string& t) { return fmt::format("--feature-file '{}'", t); }),
      count<long>("evaluations", &FitChoices::evaluations, FitOptions{}.evaluations, "--evaluations"),
      number("smoothing", &FitChoices::smoothing, parse_not_negative, 1e-9, "--smoothing"),
      flag("between", &FitChoices::between, true, "--between off"),
      input<std::string>("input_format", &InputOptions::format,
                         [](const std::string& f) { return "--input-format " + f; }),
      input<std::vector<std::string>>(
          "columns", &InputOptions::columns,
          [](const std::vector<std::string>& c) { return fmt::format("--columns {}", fmt::join(c, ",")); }),
      {"nodata", [](const FitChoices& c) { return c.input.nodata.has_value(); },
       [](const FitChoices& c) {
         return std::isnan(*c.input.nodata) ? Json(nodata_text(*c.input.nodata)) : Json(*c.input.nodata);
       },
       [](FitChoices& c, const Json& j) {
         c.input.nodata = j.is_string() ? parse_nodata(j.get<std::string>()) : j.get<double>();
       },
       [](const FitChoices& c) { return "--nodata " + nodata_text(*c.input.nodata); }},
      input<Index>("skip_lines", &InputOptions::skip_lines,
                   [](const Index& n) { return fmt::format("--skip-lines {}", n); }),
      input<std::vector<int>>(
          "classes", &InputOptions::classes,
          [](const std::vector<int>& c) { return fmt::format("--classes {}", fmt::join(c, ",")); }),
      input<std::vector<int>>("returns", &InputOptions::returns,
                              [](const std::vector<int>& r) { return "--returns " + returns_text(r); }),
      input<std::string>("weld", &InputOptions::weld,
                         [](const std::string& t) { return t == "auto" ? "" : "--weld " + t; }),
      flag("height_field", &FitChoices::height_field, false, "--height-field"),
      named("spacing", &FitChoices::spacing, kSpacings, RowSpacing::chord, "--spacing"),
      flag("rescale_parameters", &FitChoices::rescale_parameters, false, "--rescale-parameters"),
      named("duplicates", &FitChoices::duplicates, kDuplicateRules, DuplicateRule::fail, "--duplicates"),
      cell(),
      flag("fill_holes", &FitChoices::fill_holes, false, "--fill-holes"),
      flag("largest_part", &FitChoices::largest_part, false, "--largest-part"),
      flag("orient", &FitChoices::orient, false, "--orient"),
      flag("drop_degenerate", &FitChoices::drop_degenerate, false, "--drop-degenerate"),
      row<int>(
          "correct", &FitChoices::correct, [](const int& n) { return Json(correct_text(n)); },
          [](const Json& j) { return parse_correct(j.get<std::string>()); },
          [](const int& n) { return n < 0 ? std::string() : "--correct " + correct_text(n); }),
      number("fairness", &FitChoices::fairness, parse_not_negative, 1, "--fairness"),
      flag("new_parameters", &FitChoices::new_parameters, false, "--new-parameters"),
      row<std::string>(
          "corners", &FitChoices::corners, [](const std::string& t) { return Json(t); },
          [](const Json& j) {
            parse_corners(j.get<std::string>());
            return j.get<std::string>();
          },
          [](const std::string& t) { return t == "auto" ? "" : fmt::format("--corners '{}'", t); }),
      row<std::string>(
          "base", &FitChoices::base, [](const std::string& t) { return Json(t); },
          [](const Json& j) {
            parse_base(j.get<std::string>());
            return j.get<std::string>();
          },
          [](const std::string& t) { return t == "auto" ? "" : fmt::format("--base '{}'", t); }),
      number("omega", &FitChoices::omega, parse_not_negative, -1, "--omega"),
      count<int>("samples", &FitChoices::samples, kSamplesPerSpan, "--samples"),
      named_cad("unit", &CadChoices::unit, kUnits, CadUnit::millimetre, "--unit"),
      cad<std::string>(
          "name", &CadChoices::name, [](const std::string& t) { return Json(t); },
          [](const Json& j) { return j.get<std::string>(); },
          [](const std::string& t) { return fmt::format("--name '{}'", t); }),
      named_cad("step_schema", &CadChoices::schema, kSchemas, CadFormat::step_ap242, "--step-schema"),
      cad<bool>(
          "cad_safe", &CadChoices::safe, [](const bool& b) { return Json(b); },
          [](const Json& j) { return j.get<bool>(); },
          [](const bool& b) { return std::string(b ? "--cad-safe" : ""); }),
      cad<ToleranceValue>(
          "cad_tol", &CadChoices::tolerance, [](const ToleranceValue& t) { return Json(to_text(t)); },
          [](const Json& j) { return parse_tolerance(j.get<std::string>()); },
          [](const ToleranceValue& t) { return "--cad-tol " + to_text(t); }),
  };
  return rows;
}

// The "options" member of a file.
Json stored_options(const std::string& path) {
  const FileBytes file = is_dash(path) ? standard_input() : load_file(path);
  const std::string_view text = file.view();
  const Json document = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (document.is_discarded()) throw FileError(path, "is not JSON: no options to repeat");
  if (!document.is_object() || !document.contains("options") || !document["options"].is_object())
    throw FileError(path,
                    "has no \"options\": give a surface.json that knotfit fit wrote, or its --json output");
  return document["options"];
}

const Row* find_row(const std::string& name) {
  for (const Row& r : table())
    if (name == r.name) return &r;
  return nullptr;
}

}  // namespace

std::string options_to_json(const FitChoices& choices) {
  Json options = Json::object();
  for (const Row& r : table()) options[r.name] = r.given(choices) ? r.get(choices) : Json(nullptr);
  return options.dump();
}

void add_stored_options(FitChoices& choices, const std::string& path) {
  const bool size_given = choices.control_points.has_value();
  const bool knots_given = choices.knots && choices.knots->given;
  const Json stored = stored_options(path);
  for (const auto& [name, value] : stored.items()) {
    const Row* found = find_row(name);
    if (!found) throw FileError(path, "options: \"" + name + "\" is not an option of this version");
    if (value.is_null() || found->given(choices)) continue;
    if (name == "knots" && size_given && value.is_object()) continue;  // a size in place of given knots
    if (name == "control_points" && knots_given) continue;             // and the reverse
    try {
      found->set(choices, value);
    } catch (const InvalidInput& e) {
      throw FileError(path, "options: \"" + name + "\": " + e.what());
    } catch (const Json::exception&) {
      throw FileError(path, "options: \"" + name + "\" has a value of another kind: " + value.dump());
    }
  }
}

std::string options_to_text(const FitChoices& choices) {
  std::string text;
  for (const Row& r : table()) {
    if (!r.given(choices)) continue;
    const std::string one = r.text(choices);
    if (one.empty()) continue;
    if (!text.empty()) text += ' ';
    text += one;
  }
  return text;
}

}  // namespace knotfit::tool
