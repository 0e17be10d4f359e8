// Options on tolerance, size and knots of fit, compare and fit-curve.
#include <fmt/format.h>

#include <algorithm>

#include "help_text.h"
#include "knotfit/fit_curve.h"
#include "knotfit/fit_surface.h"
#include "knotfit/knot_vector.h"
#include "option_holders.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kSize = "Tolerance and size", kKnots = "Knots", kCompared = "What is compared",
                           kWhat = "What";

Holder methods() {
  return {[](Arguments& a, const std::string& t) {
    for (const std::string_view method : split(t, ',')) a.methods.emplace_back(method);
  }};
}

int single_degree(const std::string& t) {
  return count_up_to(t, 1, kMaxDegree, "a degree from 1 to 9");
}

InteriorKnots& given_knots(Arguments& a) {
  std::optional<KnotSource>& knots = a.choices.knots;
  if (!knots || !knots->given) knots = KnotSource{.method = "", .given = InteriorKnots{}};
  return *knots->given;
}

// A stored text: a method's name, or knots as U;V.
void take_stored_knots(Arguments& a, const std::string& t) {
  const std::size_t split = t.find(';');
  if (split == std::string::npos)
    a.choices.knots = KnotSource{.method = t, .given = std::nullopt};
  else
    given_knots(a) = {parse_knots(t.substr(0, split)), parse_knots(t.substr(split + 1))};
}

std::optional<std::string> print_knots(const FitChoices& c) {
  if (!c.knots) return std::nullopt;
  if (!c.knots->given) return c.knots->method;
  const auto list = [](const std::vector<double>& k) {
    return k.empty() ? "none" : fmt::format("{}", fmt::join(k, ","));
  };
  return list(c.knots->given->u) + ";" + list(c.knots->given->v);
}

// One, or several of a fit, all in % or none.
Holder tolerances() {
  const Holder one =
      kept(&FitChoices::tolerance, parse_tolerance, [](const ToleranceValue& t) { return to_text(t); });
  const auto take = [one](Arguments& a, const std::string& t) {
    a.tolerances.clear();
    if (t.find(',') == std::string::npos) return one.take(a, t);
    for (const std::string_view text : split(t, ',')) {
      a.tolerances.push_back(parse_tolerance(text));
      if (a.tolerances.back().relative != a.tolerances.front().relative)
        refuse(t, "several tolerances: all of them in %, or none");
    }
    a.choices.tolerance = a.tolerances.front();
  };
  return {take, one.print};
}

void add_tolerance_rows(std::vector<OptionRow>& rows) {
  const std::string usual = to_text(kDefaultTolerance);
  rows.push_back({.names = "--sizes",
                  .value = "NxM,...",
                  .uses = {{kCompare, kCompared, "Fixed sizes, in control points along u and v"}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    for (const std::string_view one : split(t, ',')) a.sizes.push_back(parse_pair(one, 2));
                  }},
                  .first = kCompare});
  rows.push_back(
      {.names = "--tolerances",
       .value = "X|X%,...",
       .uses = {{kCompare, kCompared, "Tolerances as --tol of fit takes them: sizes are searched to each"}},
       .holds = {[](Arguments& a, const std::string& t) {
         for (const std::string_view one : split(t, ',')) a.tolerances.push_back(parse_tolerance(one));
       }},
       .first = kCompare});
  rows.push_back(
      {.names = "--methods",
       .value = "A,B,...",
       .uses = {{kCompare, kCompared,
                 "Methods by name (knotfit methods lists them), criterion:MEASURE for a feature measure "
                 "(criterion:given: that of --feature-file); default all"}},
       .holds = methods(),
       .first = kCompare,
       .offer = Offer::all_methods,
       .more = "All are every method, and the criterion on every measure. What --feature-file gives, other "
               "methods that have a measure use too."});
  rows.push_back({.names = "--tol",
                  .value = "X|X%",
                  .uses = {{kFit, kSize,
                            "Largest error allowed: absolute, in the data's unit, or in % of the diagonal of "
                            "the data's bounding box (height fields: of the range of heights); several, as "
                            "1%,0.5%,0.1%, read the data once and number their outputs. Default, "
                            "where neither a size nor "
                            "knots are given: " +
                                usual},
                           {kCurve, kSize,
                            "Largest error allowed: absolute, or in % of the diagonal of the points' "
                            "bounding box. Default, where "
                            "neither a size nor knots are given: " +
                                usual},
                           {kDistance, kWhat,
                            "What the points may be away from the surface: absolute, or in % of the diagonal "
                            "of their bounding "
                            "box. Says which share of them is, and exits with 3 where not all are"}},
                  .holds = tolerances(),
                  .first = kFit | kCurve,
                  .stored = {.form = Form::text, .key = "tolerance"}});
  rows.push_back(
      {.names = "--within",
       .value = "P%",
       .uses = {{kFit, kSize,
                 "The share of the points that must hold the tolerance, such as 99.5%; "
                 "default 100%: the maximum counts. A measure by name is taken too: max, rms"},
                {kCurve, kSize, "The share of the points that must hold the tolerance"},
                {kCompare, kCompared, "The share of the points that must hold a tolerance"}},
       .holds = kept(&FitChoices::measure, parse_measure, [](const MeasureValue& m) { return to_text(m); }),
       .first = kFits,
       .stored = {.form = Form::measure,
                  .usual = to_text(MeasureValue{}),
                  .filled = true,
                  .key = "measure",
                  .take = [](Arguments& a, const std::string& t) { a.choices.measure = parse_measure(t); }}});
  rows.push_back(
      {.names = "--rms",
       .uses = {{kFit | kCurve, kSize, "The root mean square error counts, not the maximum"},
                {kCompare, kCompared, "The root mean square error counts in a tolerance, not the maximum"}},
       .holds = {[](Arguments& a, const std::string&) { a.choices.measure = parse_measure("rms"); }},
       .excludes = {"--within"}});
  rows.push_back({.names = "--control-points",
                  .value = "NxM",
                  .uses = {{kFit, kSize,
                            "A fixed size, in control points along u and v. With --tol too: the "
                            "size stays, the tolerance gives the verdict. \"search\" undoes a stored size"}},
                  .holds = kept(
                      &FitChoices::control_points,
                      [](const std::string& t) {
                        return t == "search" ? IntegerPair{0, 0} : parse_pair(t, 2);
                      },
                      [](const IntegerPair& p) { return fmt::format("{}x{}", p.first, p.second); }),
                  .first = kFit,
                  .stored = {.form = Form::whole_pair},
                  .excludes = {"--knots-u", "--knots-v"}});
  rows.push_back({.names = "--control-points",
                  .value = "N",
                  .uses = {{kCurve, kSize, "A fixed size; of a closed curve as many as knots in a period"}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    const auto n = static_cast<int>(std::min<long long>(parse_count(t, 2), 1 << 30));
                    a.choices.control_points = IntegerPair{n, n};
                  }},
                  .first = kCurve});
}

void add_knot_rows(std::vector<OptionRow>& rows) {
  rows.push_back(
      {.names = "--knots",
       .value = "METHOD",
       .uses = {{kFit, kKnots,
                 "How knots are placed (knotfit methods says more): " + method_names() + "; default " +
                     FitOptions{}.method},
                {kCurve, kKnots,
                 "How knots are placed (knotfit methods lists them); default " + CurveFitOptions{}.method}},
       .holds = {[](Arguments& a, const std::string& t) {
                   a.choices.knots = KnotSource{.method = t, .given = std::nullopt};
                 },
                 print_knots},
       .first = kFit | kCurve,
       .stored =
           {.form = Form::knots, .usual = FitOptions{}.method, .filled = true, .take = take_stored_knots},
       .offer = Offer::methods,
       .excludes = {"--knots-u", "--knots-v"},
       .more = "Optimal knots minimise the error itself; error-model takes less time and some more control "
               "points."});
  rows.push_back(
      {.names = "--knots-u",
       .value = "A,B,...",
       .uses = {{kFit, kKnots,
                 "Interior knots along u, increasing in (0,1); none for none. Parameters run over [0,1]"}},
       .holds = {[](Arguments& a, const std::string& t) { given_knots(a).u = parse_knots(t); }},
       .needs = {"--knots-v"},
       .brief = "Interior knots along u"});
  rows.push_back({.names = "--knots-v",
                  .value = "A,B,...",
                  .uses = {{kFit, kKnots, "The same along v"}},
                  .holds = {[](Arguments& a, const std::string& t) { given_knots(a).v = parse_knots(t); }},
                  .needs = {"--knots-u"},
                  .brief = "Interior knots along v"});
  rows.push_back(
      {.names = "--knots-from",
       .value = "SURFACE",
       .uses = {{kFit, kKnots,
                 "Knots, and unless --degree is given degrees, of a surface.json, STEP or IGES file"}},
       .holds = {[](Arguments& a, const std::string& t) { a.knots_from = t; }},
       .offer = Offer::surfaces,
       .excludes = {"--knots-u", "--knots-v", "--knots", "--control-points"}});
  rows.push_back(
      {.names = "--knots-t",
       .value = "A,B,...",
       .uses = {{kCurve, kKnots,
                 "Knots given: interior ones, increasing in (0,1); of a closed curve those of a period, its "
                 "seam at 0 left out"}},
       .holds = {[](Arguments& a, const std::string& t) { a.knots_t = parse_knots(t); }},
       .excludes = {"--knots", "--control-points"}});
  rows.push_back(
      {.names = "--compare",
       .value = "A,B,...",
       .uses =
           {{kCurve, kKnots,
             "A table of these methods, or of all, in place of one curve; criterion:MEASURE for a feature "
             "measure (criterion:given: that of --feature-file)"}},
       .holds = methods(),
       .first = kCurve,
       .offer = Offer::all_methods,
       .excludes = {"--knots"}});
}

void add_degree_rows(std::vector<OptionRow>& rows) {
  const FitOptions usual;
  const std::string degree = fmt::format("{}", usual.degree_u);
  const auto print = [](const IntegerPair& d) { return degree_text(d); };
  rows.push_back({.names = "--degree",
                  .value = "D|DxE|auto",
                  .uses = {{kFit, kSize,
                            "Degree along u and v, 1 to 9; default " + degree +
                                ". auto: 3, 4 and 5 are tried, and the fewest control points win"}},
                  .holds = kept(&FitChoices::degree, parse_degree, print),
                  .first = kFit,
                  .stored = {.form = Form::whole_pair,
                             .usual = degree_text({usual.degree_u, usual.degree_v}),
                             .filled = true}});
  rows.push_back({.names = "--degree",
                  .value = "D|DxE",
                  .uses = {{kCompare, kCompared, "Degree along u and v, 1 to 9; default " + degree}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    const IntegerPair pair = parse_pair(t, 1);
                    if (pair.first > kMaxDegree || pair.second > kMaxDegree)
                      refuse(t, "a degree from 1 to 9");
                    a.choices.degree = pair;
                  }},
                  .first = kCompare});
  rows.push_back(
      {.names = "--degree",
       .value = "D",
       .uses = {{kCurve, kSize, fmt::format("Degree, 1 to 9; default {}", CurveFitOptions{}.degree)}},
       .holds = {[](Arguments& a, const std::string& t) {
         const int d = single_degree(t);
         a.choices.degree = IntegerPair{d, d};
       }},
       .first = kCurve});
  rows.push_back(
      {.names = "--shear",
       .value = "auto|off|A|v:A",
       .uses = {{kFit, kSize,
                 "Oblique parameters for the oblique features of a height field: u + A v in place of u (v:A: "
                 "v + A u), "
                 "A from -1 to 1; auto finds A, fits with it and without, and keeps the smaller surface. The "
                 "parameters "
                 "change, and the corners of the surface lie beyond the data; default " +
                     shear_text({})}},
       .holds = kept(&FitChoices::shear, parse_shear, [](const ShearChoice& s) { return shear_text(s); }),
       .stored = {.form = Form::text, .usual = shear_text({}), .filled = true},
       .acts = {.on_input = [](const InputTraits& i) { return i.raster || i.height_field || !i.sheared; },
                .purpose = "it is for height fields, whose x and y it shears"}});
}

void add_search_rows(std::vector<OptionRow>& rows) {
  const FitOptions usual;
  rows.push_back(
      {.names = "--refine",
       .value = one_of(kRoutes),
       .uses =
           {{kFit, kKnots,
             "How a tolerance is reached: sizes searched, knots placed anew at "
             "each (search, default), or knot lines inserted where features or errors are large (insert)"}},
       .holds = named(&FitChoices::refine, kRoutes),
       .stored = {.form = Form::text, .usual = std::string(name_of(kRoutes, usual.route)), .filled = true},
       .excludes = {"--knots-u", "--knots-v", "--knots-from", "--control-points"}});
  rows.push_back(
      {.names = "--effort",
       .value = one_of(kEfforts),
       .uses =
           {{kFit, kKnots,
             "Work of a search with optimal knots, counted in fits: fast (no minimax), balanced (default), "
             "best (every start, every neighbouring size, insertion as well)"}},
       .holds = named(&FitChoices::effort, kEfforts),
       .stored = {.form = Form::text, .usual = std::string(name_of(kEfforts, usual.effort)), .filled = true},
       .more = "best makes second tries too."});
  rows.push_back(
      {.names = "--guard",
       .value = one_of(kSwitch),
       .uses = {{kFit, kKnots,
                 fmt::format(
                     "Hold a search with optimal knots to the data between its points too; default {}",
                     name_of(kSwitch, usual.guard))}},
       .holds = named(&FitChoices::guard, kSwitch),
       .stored = {.form = Form::on_off, .usual = std::string(name_of(kSwitch, usual.guard)), .filled = true},
       .more =
           "Where knots come so near to each other that a surface could swing unseen, local estimates from "
           "the data join the fit."});
  rows.push_back(
      {.names = "--engine",
       .value = one_of(kEngines),
       .uses = {{kFit, kKnots,
                 "What the knots of optimal and error-model are found on: points (all), sample (some 20 000; "
                 "optimal knots let the worst of all join until every point holds), auto (the sample where "
                 "that is much less work; default). The verdict is always on all points"}},
       .holds = named(&FitChoices::engine, kEngines),
       .stored = {.form = Form::text, .usual = std::string(name_of(kEngines, usual.engine)), .filled = true},
       .more = "Of meshes, and of clouds without parameters, 'points' maps every point; 'sample', and 'auto' "
               "above 100 000 "
               "points, "
               "maps 20 000, and the worst of the others join them."});
  rows.push_back(
      {.names = "--max-control-points",
       .value = "N",
       .uses = {{kFit, kSize,
                 "Most control points; default: half of the points, for scattered data at most 50000"},
                {kCurve, kSize, "Most control points; default: half of the points"},
                {kCompare, kCompared, "Most control points of a search"}},
       .holds = count(&FitChoices::max_control_points),
       .first = kCompare,
       .stored = {.form = Form::whole}});
  rows.push_back(
      {.names = "--max-fits",
       .value = "N",
       .uses = {{kFit, kSize, "Most linear fits of one search; default: by the size of the search"},
                {kCurve, kSize, "Most linear fits of a search; default 100000"},
                {kCompare, kCompared, "Most linear fits of one search"}},
       .holds = count(&FitChoices::max_fits),
       .stored = {.form = Form::whole},
       .more = "Budgets count fits, so that a result does not depend on the machine."});
  rows.push_back(
      {.names = "--time-limit",
       .value = "S",
       .uses = {{kFit, kSize,
                 "Seconds after which the best surface so far is taken (status time_limit); default: none"},
                {kCurve, kSize,
                 "Seconds after which a search tries no further size: the best so far is taken (status "
                 "time_limit); default: none"}},
       .holds = real(&FitChoices::time_limit, parse_positive),
       .first = kFit,
       .stored = {.form = Form::real},
       .brief = "Seconds"});
}

void add_measure_rows(std::vector<OptionRow>& rows) {
  const FitOptions usual;
  const std::string feature(name_of(feature_names(), usual.feature));
  rows.push_back(
      {.names = "--feature",
       .value = one_of(feature_names()),
       .uses = {{kFit, kKnots, "Feature measure of the criterion and of insertion; default " + feature},
                {kCompare, kCompared, "Feature measure of methods that have one; default " + feature},
                {kCurve, kKnots, "Feature measure of methods that have one; default " + feature}},
       .holds = named(&FitChoices::feature, feature_names()),
       .stored = {.form = Form::text, .usual = feature, .filled = true}});
  const std::string file =
      "A feature measure of your own, in place of --feature: a grid, or points x,y,z or u,v,z in the data's "
      "parameters, whose z is the measure, at least 0";
  rows.push_back(
      {.names = "--feature-file",
       .value = "FILE",
       .uses = {{kFit, kKnots, file},
                {kCompare, kCompared, file},
                {kCurve, kKnots,
                 "A feature measure of your own, in place of --feature: two columns, t from 0 to 1 (with "
                 "--function: x) and the measure, at least 0"}},
       .holds = text(&FitChoices::feature_file),
       .stored = {.form = Form::words},
       .offer = Offer::files,
       .more = "Averaged over 200 x 200 cells; values outside the data are left out."});
  const std::string evaluations =
      fmt::format("Of the error, in an evolutionary search at one size; default {}", usual.evaluations);
  rows.push_back({.names = "--evaluations",
                  .value = "N",
                  .uses = {{kFit | kCurve, kKnots, evaluations}, {kCompare, kCompared, evaluations}},
                  .holds = count(&FitChoices::evaluations),
                  .stored = {.form = Form::whole, .usual = std::to_string(usual.evaluations)}});
  const std::string floor = "Relative smoothing floor of the least squares; default ";
  rows.push_back({.names = "--smoothing",
                  .value = "X",
                  .uses = {{kFit, kKnots, floor + short_number(usual.smoothing)},
                           {kCompare, kCompared, floor + short_number(usual.smoothing)},
                           {kCurve, kKnots, floor + short_number(CurveFitOptions{}.smoothing)}},
                  .holds = real(&FitChoices::smoothing, parse_not_negative),
                  .stored = {.form = Form::real, .usual = number_text(usual.smoothing), .filled = true}});
  rows.push_back(
      {.names = "--between",
       .value = one_of(kSwitch),
       .uses = {{kFit, "Running",
                 fmt::format("Measure the surface between the points too; default {}",
                             name_of(kSwitch, usual.between))},
                {kCompare, "Running",
                 fmt::format("Measure the surfaces between the points too; default {}",
                             name_of(kSwitch, usual.between))}},
       .holds = named(&FitChoices::between, kSwitch),
       .stored = {
           .form = Form::on_off, .usual = std::string(name_of(kSwitch, usual.between)), .filled = true}});
}

}  // namespace

void add_size_rows(std::vector<OptionRow>& rows) {
  add_tolerance_rows(rows);
  add_knot_rows(rows);
  add_degree_rows(rows);
  add_search_rows(rows);
  add_measure_rows(rows);
}

}  // namespace knotfit::tool
