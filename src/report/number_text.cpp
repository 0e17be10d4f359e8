#include "report/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
namespace knotfit::report {
namespace {

std::string true_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "−");
  return text;
}

// Decimals that tell x, x + step, x + 2 step ... apart.
int decimals_of(double step) {
  for (int d = 0; d < 18; ++d) {
    const double scaled = step * std::pow(10.0, d);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled && std::round(scaled) > 0) return d;
  }
  return 18;
}

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);  // -0
  return true_minus(text);
}

}  // namespace

std::string power_of_ten(int exponent) {
  static const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (char c : std::to_string(std::abs(exponent))) out += raised[c - '0'];
  return out;
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "?" : value > 0 ? "∞" : "−∞";
  if (value == 0) return "0";
  const std::string scientific = fmt::format("{:.{}e}", value, std::max(0, digits - 1));
  const std::size_t e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent >= -4 && exponent < 5)
    return true_minus(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent)));
  return true_minus(scientific.substr(0, e)) + " × " + power_of_ten(exponent);
}

std::string short_number_text(double value) {
  for (int digits = 1; digits < 5; ++digits) {
    const double rounded = std::stod(fmt::format("{:.{}e}", value, digits - 1));
    if (std::abs(rounded - value) <= 1e-9 * std::abs(value)) return number_text(value, digits);
  }
  return number_text(value, 3);
}

std::string count_text(Index count) {
  std::string text = std::to_string(count);
  const std::size_t first = text[0] == '-' ? 1 : 0;
  if (text.size() - first <= 4) return true_minus(text);
  for (std::size_t at = text.size(); at > first + 3;) {
    at -= 3;
    text.insert(at, "\u2009");  // thin space
  }
  return true_minus(text);
}

Ticks make_ticks(double low, double high, int most) {
  Ticks ticks;
  if (!(high > low) || !std::isfinite(high - low)) {
    ticks.at = {low};
    ticks.text = {number_text(low, 6)};
    return ticks;
  }
  const double width = high - low;
  const double power = std::pow(10.0, std::floor(std::log10(width / std::max(1, most))));
  double step = 0;
  Index first = 0, last = -1;
  for (double factor : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0, 25.0, 50.0}) {
    step = factor * power;
    if (std::max(std::abs(low), std::abs(high)) / step > 1e15) {  // no two doubles between ticks
      ticks.at = {low};
      ticks.text = {number_text(low, 6)};
      return ticks;
    }
    first = static_cast<Index>(std::ceil(low / step - 1e-9));
    last = static_cast<Index>(std::floor(high / step + 1e-9));
    if (last - first + 1 <= std::max(1, most)) break;
  }
  for (Index k = first; k <= last; ++k)
    ticks.at.push_back(std::clamp(static_cast<double>(k) * step, low, high));

  const double largest = std::max(std::abs(low), std::abs(high));
  const int decimals = decimals_of(step);
  const int whole = largest >= 1 ? static_cast<int>(std::floor(std::log10(largest))) + 1 : 1;
  double offset = 0;
  int exponent = 0;
  if (whole + decimals > 7 && width < 0.02 * largest) {
    const double unit = std::pow(10.0, std::ceil(std::log10(width)) + 1);
    offset = std::floor(low / unit) * unit;
    const double rest = std::max(std::abs(low - offset), std::abs(high - offset));
    if (rest < 1e-2 || rest >= 1e5) exponent = static_cast<int>(std::floor(std::log10(rest)));
  } else if ((largest >= 1e6 && (whole + decimals > 7 || width >= 0.02 * largest)) || largest < 1e-2) {
    exponent = static_cast<int>(std::floor(std::log10(largest)));
  }
  const double factor = std::pow(10.0, exponent);
  const int shown = decimals_of(step / factor);
  for (double t : ticks.at) ticks.text.push_back(fixed((t - offset) / factor, std::min(shown, 12)));
  if (offset != 0) {
    const double amount = std::abs(offset);
    ticks.offset = (offset > 0 ? "− " : "+ ") + (amount >= 1 && amount < 1e15 && amount == std::round(amount)
                                                     ? count_text(static_cast<Index>(amount))
                                                     : number_text(amount, 9));
  }
  ticks.exponent = exponent;
  return ticks;
}

std::string Ticks::name(const std::string& quantity, const std::string& unit) const {
  std::string out = offset.empty() ? quantity : quantity + " " + offset;
  if (exponent != 0)
    out += " (" + power_of_ten(exponent) + (unit.empty() ? "" : " " + unit) + ")";
  else if (!unit.empty())
    out += " (" + unit + ")";
  return out;
}

std::vector<double> make_log_ticks(double low, double high) {
  static constexpr double kDigits[] = {1, 2, 5, 1.2, 1.5, 2.5, 3, 4, 6, 8};
  const double decades = high - low;
  const int digits = decades < 0.8 ? 10 : decades < 2.5 ? 3 : 1;
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 15)));
  std::vector<double> ticks;
  for (int e = static_cast<int>(std::floor(low)); e <= static_cast<int>(std::ceil(high)); ++e) {
    if (e % step != 0) continue;
    for (int k = 0; k < digits; ++k) {
      const double x = kDigits[k] * std::pow(10.0, e);
      if (std::log10(x) >= low && std::log10(x) <= high) ticks.push_back(x);
    }
  }
  std::sort(ticks.begin(), ticks.end());
  return ticks;
}

}  // namespace knotfit::report
