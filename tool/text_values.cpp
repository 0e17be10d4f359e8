#include "text_values.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "fit/error_measure.h"
#include "formats/columns.h"
#include "formats/missing.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
namespace knotfit::tool {
namespace {

std::string_view trim(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

template <class T>
std::optional<T> whole(std::string_view text) {
  text = trim(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> finite(std::string_view text) {
  const std::optional<double> value = whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool drop_percent(std::string_view& text) {
  text = trim(text);
  if (text.empty() || text.back() != '%') return false;
  text.remove_suffix(1);
  return true;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

void refuse(std::string_view text, const std::string& wanted) {
  throw InvalidInput(fmt::format("'{}' is not {}", text, wanted));
}

double parse_number(std::string_view text) {
  const std::optional<double> value = finite(text);
  if (!value) refuse(text, "a number");
  return *value;
}

double parse_positive(std::string_view text) {
  const std::optional<double> value = finite(text);
  if (!value || *value <= 0) refuse(text, "a number above 0");
  return *value;
}

double parse_not_negative(std::string_view text) {
  const std::optional<double> value = finite(text);
  if (!value || *value < 0) refuse(text, "a number of 0 or more");
  return *value;
}

long long parse_count(std::string_view text, long long least) {
  const std::optional<long long> value = whole<long long>(text);
  if (!value || *value < least) refuse(text, fmt::format("a whole number of {} or more", least));
  return *value;
}

ToleranceValue parse_tolerance(std::string_view text) {
  std::string_view number = text;
  ToleranceValue tolerance;
  tolerance.relative = drop_percent(number);
  const std::optional<double> value = finite(number);
  if (!value || *value <= 0)
    refuse(text, "a tolerance: a number above 0 in the data's unit, or in % such as 0.1%");
  tolerance.value = *value;
  return tolerance;
}

MeasureValue parse_percentile(std::string_view text) {
  std::string_view number = text;
  const bool percent = drop_percent(number);
  const std::optional<double> value = finite(number);
  if (!percent || !value || *value <= 0 || *value > 100)
    refuse(text, "a share of the points, above 0% and up to 100%, such as 99.5%");
  if (*value == 100) return {ErrorMeasure::max, 1};
  return {ErrorMeasure::percentile, *value / 100};
}

MeasureValue parse_measure(std::string_view text) {
  for (const ErrorMeasureRow& row : error_measures())
    if (!row.needs_share && row.name == text) return {row.measure, 1};
  return parse_percentile(text);
}

IntegerPair parse_pair(std::string_view text, int least) {
  const auto parts = split(text, 'x');
  const auto first = whole<int>(parts[0]);
  const auto second = parts.size() == 2 ? whole<int>(parts[1]) : first;
  if (parts.size() > 2 || !first || !second || *first < least || *second < least)
    refuse(text, fmt::format("two whole numbers of {} or more such as 40x30, or one for both", least));
  return {*first, *second};
}

IntegerPair parse_degree(std::string_view text) {
  if (text == "auto") return {0, 0};
  const IntegerPair degree = parse_pair(text, 1);
  if (degree.first > kMaxDegree || degree.second > kMaxDegree) refuse(text, "a degree from 1 to 9, or auto");
  return degree;
}

std::string degree_text(const IntegerPair& degree) {
  return degree.first == 0 ? "auto" : fmt::format("{}x{}", degree.first, degree.second);
}

IntegerPair parse_orders(std::string_view text) {
  const auto parts = split(text, ',');
  const auto first = whole<int>(parts[0]);
  const auto second = parts.size() == 2 ? whole<int>(parts[1]) : std::nullopt;
  if (!first || !second || *first < 0 || *second < 0 || *first > 20 || *second > 20)
    refuse(text, "two orders of differentiation of 0 to 20 such as 1,0");
  return {*first, *second};
}

std::pair<double, double> parse_position(std::string_view text) {
  const auto parts = split(text, ',');
  const auto first = finite(parts[0]);
  const auto second = parts.size() == 2 ? finite(parts[1]) : std::nullopt;
  if (!first || !second) refuse(text, "two numbers such as 0.25,0.5");
  return {*first, *second};
}

std::pair<double, double> parse_cell(std::string_view text) {
  const auto parts = split(text, 'x');
  const auto first = finite(parts[0]);
  const auto second = parts.size() == 2 ? finite(parts[1]) : first;
  if (parts.size() > 2 || !first || !second || *first <= 0 || *second <= 0)
    refuse(text, "a cell size above 0 such as 30, or two such as 30x25");
  return {*first, *second};
}

std::vector<double> parse_knots(std::string_view text) {
  std::vector<double> knots;
  if (trim(text).empty() || text == "none") return knots;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> knot = finite(part);
    if (!knot || *knot <= 0 || *knot >= 1 || (!knots.empty() && *knot < knots.back()))
      refuse(part, "the next interior knot: give increasing numbers inside (0,1) such as 0.2,0.5, or none");
    knots.push_back(*knot);
  }
  return knots;
}

WeldChoice parse_weld(std::string_view text) {
  if (text == "auto") return {};
  if (text == "off") return {.off = true};
  std::string_view number = text;
  ToleranceValue tolerance;
  tolerance.relative = drop_percent(number);
  const std::optional<double> value = finite(number);
  if (!value || *value < 0)
    refuse(text, "auto, off, or a distance of 0 or more, in the data's unit or in % of the diagonal");
  tolerance.value = *value;
  return {.tolerance = tolerance};
}

CornerChoice parse_corners(std::string_view text) {
  constexpr const char* kWanted =
      "auto, sharpest, search, four vertices \"i,j,k,l\" or four places \"x,y,z;...\"";
  for (const auto& entry : kCornerRules)
    if (entry.name == text) return {.rule = entry.value};
  CornerChoice choice;
  const auto places = split(text, ';');
  if (places.size() == 4) {
    for (const std::string_view place : places) {
      const auto numbers = split(place, ',');
      if (numbers.size() != 3) refuse(text, kWanted);
      choice.places.push_back({parse_number(numbers[0]), parse_number(numbers[1]), parse_number(numbers[2])});
    }
    return choice;
  }
  const auto numbers = split(text, ',');
  if (places.size() != 1 || numbers.size() != 4) refuse(text, kWanted);
  for (const std::string_view number : numbers) choice.vertices.push_back(parse_count(number, 0));
  return choice;
}

BaseChoice parse_base(std::string_view text) {
  for (const auto& entry : kBases)
    if (entry.name == text) {
      if (entry.value == CloudBase::given || entry.value == CloudBase::surface) break;
      return {.kind = entry.value};
    }
  BaseChoice choice{.kind = CloudBase::surface};
  const auto parts = split(text, ',');
  if (parts.size() == 1 && text.find('.') != std::string_view::npos) {
    choice.surface = std::string(text);
    return choice;
  }
  if (parts.size() != 4)
    refuse(text,
           "auto, plane, cylinder, graph, the file of a surface, or those of four boundary curves: A,B,C,D");
  for (const std::string_view part : parts) choice.curves.emplace_back(part);
  return choice;
}

std::vector<std::string> parse_columns(std::string_view text) {
  std::vector<std::string> columns;
  for (const std::string_view part : split(text, ',')) {
    const Role role = role_of(part);
    if (role == Role::skip && part != "-" && attribute_of(part).empty())
      refuse(part,
             "a column: give x, y, z, u, v, w, nx, ny, nz, or what is left out: r, g, b, intensity, time or "
             "- for "
             "each, such as x,y,z,u,v");
    if (role != Role::skip)
      for (const std::string& other : columns)
        if (role_of(other) == role) throw InvalidInput(fmt::format("column '{}' is given twice", part));
    columns.emplace_back(part);
  }
  return columns;
}

double parse_nodata(std::string_view text) {
  if (is_missing_word(text) || trim(text) == "empty") return std::numeric_limits<double>::quiet_NaN();
  const std::optional<double> value = finite(text);
  if (!value) refuse(text, "a number, or a word for missing data: nan, NA, null, empty");
  return *value;
}

std::string nodata_text(double nodata) {
  return std::isnan(nodata) ? "nan" : fmt::format("{}", nodata);
}

std::vector<int> parse_classes(std::string_view text) {
  std::vector<int> classes;
  for (const std::string_view part : split(text, ',')) {
    const long long n = parse_count(part, 0);
    if (n > 255) refuse(part, "a class from 0 to 255");
    classes.push_back(static_cast<int>(n));
  }
  return classes;
}

std::vector<int> parse_returns(std::string_view text) {
  std::vector<int> returns;
  for (const std::string_view part : split(text, ',')) {
    if (part == "first" || part == "last") {
      returns.push_back(part == "first" ? 1 : kLastReturn);
      continue;
    }
    const long long n = parse_count(part, 1);
    if (n > 15) refuse(part, "first, last, or the number of a return from 1 to 15");
    returns.push_back(static_cast<int>(n));
  }
  return returns;
}

std::string returns_text(const std::vector<int>& returns) {
  std::string text;
  for (const int n : returns)
    text += (text.empty() ? "" : ",") + (n == kLastReturn ? "last" : std::to_string(n));
  return text;
}

std::string to_text(const ToleranceValue& tolerance) {
  return fmt::format("{}{}", tolerance.value, tolerance.relative ? "%" : "");
}

std::string to_text(const MeasureValue& measure) {
  if (const ErrorMeasureRow& row = row_of(measure.measure); !row.needs_share) return std::string(row.name);
  // The shortest percentage that reads back to the same share.
  for (int digits = 3; digits < 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", 100 * measure.share, digits);
    if (finite(text).value_or(0) / 100 == measure.share) return text + "%";
  }
  return fmt::format("{}%", 100 * measure.share);
}

const std::vector<Named<FeatureMeasure>>& feature_names() {
  static const std::vector<Named<FeatureMeasure>> names = [] {
    std::vector<Named<FeatureMeasure>> all;
    for (const FeatureMeasureInfo& row : feature_measures()) all.push_back({row.measure, row.name});
    return all;
  }();
  return names;
}

std::string number_text(double number) {
  return fmt::format("{}", number);
}

std::string short_number(double number) {
  std::string text = number_text(number);
  if (const std::size_t e = text.find("e-0"); e != std::string::npos) text.erase(e + 2, 1);
  return text;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

ShearChoice parse_shear(std::string_view text) {
  if (text == "auto") return {.automatic = true};
  if (text == "off") return {};
  const bool in_v = text.starts_with("v:");
  const std::string_view number = in_v || text.starts_with("u:") ? text.substr(2) : text;
  const double shear = parse_number(number);
  if (!(std::abs(shear) <= 1)) refuse(text, "a shear from -1 to 1");
  return in_v ? ShearChoice{.v = shear} : ShearChoice{.u = shear};
}

std::string shear_text(const ShearChoice& shear) {
  if (shear.automatic) return "auto";
  if (shear.v != 0) return fmt::format("v:{}", shear.v);
  return shear.u != 0 ? fmt::format("u:{}", shear.u) : "off";
}

int parse_correct(std::string_view text) {
  if (text == "auto") return -1;
  if (text == "off") return 0;
  const long long rounds = parse_count(text, 1);
  if (rounds > 100000) refuse(text, "auto, off, or a number of rounds up to 100000");
  return static_cast<int>(rounds);
}

std::string correct_text(int rounds) {
  return rounds < 0 ? "auto" : rounds == 0 ? "off" : fmt::format("{}", rounds);
}

}  // namespace knotfit::tool
