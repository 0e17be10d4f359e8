// Numbers as a reader of a picture wants them: few digits, true minus signs, powers of ten raised.
#pragma once
#include <string>
#include <vector>

#include "knotfit/index.h"
namespace knotfit::report {

/// `digits` significant digits: 0.00123, 12.3, 1.23 × 10⁻⁷.
std::string number_text(double value, int digits = 3);
/// As few digits as give the value, else 3: for figures that a user typed.
std::string short_number_text(double value);
/// With a thin space between thousands: 17 157.
std::string count_text(Index count);
/// 10^exponent with the exponent raised.
std::string power_of_ten(int exponent);

struct Ticks {
  std::vector<double> at;         ///< in [low, high]
  std::vector<std::string> text;  ///< one a tick
  std::string offset;             ///< "− 500 000" where the texts are of value - 500 000; or empty
  int exponent = 0;               ///< the texts are of value / 10^exponent

  /// The axis's name with what the texts leave out: "x − 500 000 (10³ m)".
  std::string name(const std::string& quantity, const std::string& unit = {}) const;
};
/// Round values (1, 2, 2.5 or 5 times a power of ten apart), at most `most` of them; one tick where
/// low = high.
Ticks make_ticks(double low, double high, int most);
/// Of a logarithmic axis from 10^low to 10^high, at least a factor of 2 apart: powers of ten, on shorter axes with 2 and
/// 5 times them, on the shortest with more. Two at least, 16 at most.
std::vector<double> make_log_ticks(double low, double high);

}  // namespace knotfit::report
