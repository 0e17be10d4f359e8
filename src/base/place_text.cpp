#include "base/place_text.h"

#include <charconv>
namespace knotfit {

std::string place_text(double coordinate) {
  char text[40];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, coordinate, std::chars_format::general, 12);
  return {text, end};
}

}  // namespace knotfit
