// Values as they are written on the command line and in stored options.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "options.h"
namespace knotfit::tool {

/// One name of an enumeration, as the command line and the stored options spell it.
template <class E>
struct Named {
  E value;
  std::string_view name;
};
inline constexpr Named<RefineRoute> kRoutes[] = {{RefineRoute::search, "search"},
                                                 {RefineRoute::insert, "insert"}};
inline constexpr Named<Effort> kEfforts[] = {
    {Effort::fast, "fast"}, {Effort::balanced, "balanced"}, {Effort::best, "best"}};
inline constexpr Named<Engine> kEngines[] = {
    {Engine::automatic, "auto"}, {Engine::points, "points"}, {Engine::sample, "sample"}};
inline constexpr Named<RowSpacing> kSpacings[] = {
    {RowSpacing::chord, "chord"}, {RowSpacing::centripetal, "centripetal"}, {RowSpacing::uniform, "uniform"}};
inline constexpr Named<DuplicateRule> kDuplicateRules[] = {{DuplicateRule::fail, "fail"},
                                                           {DuplicateRule::mean, "mean"},
                                                           {DuplicateRule::lowest, "lowest"},
                                                           {DuplicateRule::highest, "highest"}};
inline constexpr Named<CornerRule> kCornerRules[] = {
    {CornerRule::automatic, "auto"}, {CornerRule::sharpest, "sharpest"}, {CornerRule::search, "search"}};
inline constexpr Named<CloudBase> kBases[] = {{CloudBase::automatic, "auto"},    {CloudBase::plane, "plane"},
                                              {CloudBase::cylinder, "cylinder"}, {CloudBase::graph, "graph"},
                                              {CloudBase::surface, "surface"},   {CloudBase::given, "given"}};
inline constexpr Named<CadUnit> kUnits[] = {
    {CadUnit::millimetre, "mm"}, {CadUnit::metre, "m"}, {CadUnit::inch, "inch"}};
inline constexpr Named<CadFormat> kSchemas[] = {{CadFormat::step_ap214, "ap214"},
                                                {CadFormat::step_ap242, "ap242"}};
inline constexpr Named<bool> kMaps[] = {{true, "newton"}, {false, "mean-value"}};
inline constexpr Named<bool> kSwitch[] = {{true, "on"}, {false, "off"}};

/// The parts between the marks, without blanks around them; one where there is no mark.
std::vector<std::string_view> split(std::string_view text, char mark);

/// The library's feature measures.
const std::vector<Named<FeatureMeasure>>& feature_names();

// Every function below throws InvalidInput that quotes the text and says what is wanted.

double parse_number(std::string_view text);
double parse_positive(std::string_view text);
double parse_not_negative(std::string_view text);
long long parse_count(std::string_view text, long long least);
/// "0.1%" or "0.05"; > 0.
ToleranceValue parse_tolerance(std::string_view text);
/// "max", "rms" or a percentile as parse_percentile.
MeasureValue parse_measure(std::string_view text);
/// "99.5%", in (0,100]; 100% is max.
MeasureValue parse_percentile(std::string_view text);
/// "40x30", or "40" for both; each at least `least`.
IntegerPair parse_pair(std::string_view text, int least);
/// As parse_pair, 1 to 9; "auto": 0 x 0.
IntegerPair parse_degree(std::string_view text);
std::string degree_text(const IntegerPair& degree);

/// "auto", "off", "A", "u:A" or "v:A", A in [-1,1].
ShearChoice parse_shear(std::string_view text);
std::string shear_text(const ShearChoice& shear);
/// "a,b".
IntegerPair parse_orders(std::string_view text);
std::pair<double, double> parse_position(std::string_view text);
/// "10" or "10x20", > 0.
std::pair<double, double> parse_cell(std::string_view text);
/// "0.2,0.5", increasing inside (0,1); "none" or nothing: no knots.
std::vector<double> parse_knots(std::string_view text);
/// "auto", "sharpest", "search"; "i,j,k,l"; "x,y,z;x,y,z;x,y,z;x,y,z".
CornerChoice parse_corners(std::string_view text);
/// "auto", "off", or a tolerance of 0 or more as parse_tolerance.
WeldChoice parse_weld(std::string_view text);
/// The words of kBases, a surface's file, or those of four curves.
BaseChoice parse_base(std::string_view text);

/// "x,y,z,-,u,v": the names that a header may have, - for a column to leave out.
std::vector<std::string> parse_columns(std::string_view text);

/// A number, or NaN for a word that stands for missing data: nan, NA, null, empty.
double parse_nodata(std::string_view text);
std::string nodata_text(double nodata);

/// Numbers of classes, 0 to 255.
std::vector<int> parse_classes(std::string_view text);
/// Numbers of returns, 1 to 15; first is 1, last is kLastReturn.
std::vector<int> parse_returns(std::string_view text);
std::string returns_text(const std::vector<int>& returns);

/// The names of a table.
template <class Table>
std::string one_of(const Table& table, std::string_view separator = "|") {
  std::string names;
  for (const auto& entry : table) {
    if (!names.empty()) names += separator;
    names += entry.name;
  }
  return names;
}

[[noreturn]] void refuse(std::string_view text, const std::string& wanted);

template <class Table>
auto parse_named(const Table& table, std::string_view text) {
  for (const auto& entry : table)
    if (entry.name == text) return entry.value;
  refuse(text, "one of " + one_of(table, ", "));
}

template <class Table, class E>
std::string_view name_of(const Table& table, E value) {
  for (const auto& entry : table)
    if (entry.value == value) return entry.name;
  return "";
}

/// The text that parse_tolerance, parse_measure read back to the same value.
std::string to_text(const ToleranceValue& tolerance);
std::string to_text(const MeasureValue& measure);

/// The shortest text that reads back to the same number; short_number() without the zeros of its exponent: 1e-9.
std::string number_text(double number);
std::string short_number(double number);

/// Extension in lower case with its dot; empty where there is none.
std::string extension_of(const std::string& path);

/// --correct: auto (-1), off (0) or a number of rounds.
int parse_correct(std::string_view text);
std::string correct_text(int rounds);

}  // namespace knotfit::tool
