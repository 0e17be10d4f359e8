// Values that are missing: the words for them, and points without them.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/source_data.h"
namespace knotfit {

/// nan, NA, N/A, null, none, missing, -, an empty cell: in any case, with or without quotes.
bool is_missing_word(std::string_view token);

/// What tells a user how to go on where a value is missing.
std::string leave_out_hint();

/// Whether the point of these coordinates and other values has a nodata value: z, or the last coordinate where there is
/// no z; NaN as nodata stands for every value that is not finite.
bool misses_value(double coordinate, bool all_finite, std::optional<double> nodata);

/// Drops the points (ascending indices) from every column.
void drop_points(PointTable& table, const std::vector<Index>& points);

/// Drops the points that have the nodata value in another column than z, where it can be no value: outside the other
/// values there, and 10 times as far as they spread where it is a small number such as 0.
/// \return how many
Index drop_far_nodata(PointTable& table, std::optional<double> nodata);

/// "3 points left out: the value -9999 stands for none (`nodata`)".
std::string left_out_note(Index count, double nodata);

}  // namespace knotfit
