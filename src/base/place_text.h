// Coordinates in messages.
#pragma once
#include <string>
namespace knotfit {

/// A coordinate with the digits that find its place: 12, so that metres of a map projection keep their micrometres;
/// what rounding left behind them is not shown.
std::string place_text(double coordinate);

}  // namespace knotfit
