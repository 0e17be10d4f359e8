// Residuals as CSV.
#include <fmt/format.h>

#include <ostream>
#include <string>

#include "formats/number.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
namespace knotfit {

void write_residuals(std::ostream& out, const ParameterizedPoints& points, std::span<const double> errors) {
  const Index n = points.size();
  const int d = points.dimension;
  if (d < 1 || errors.size() != static_cast<std::size_t>(n) ||
      points.values.size() != static_cast<std::size_t>(n) * static_cast<std::size_t>(d))
    throw InvalidInput(fmt::format("{} errors and {} values of dimension {} for {} points", errors.size(),
                                   points.values.size(), d, n));
  const bool height = points.height_field && d == 1;
  std::string text = height || d >= 3 ? "x,y,z" : d == 2 ? "x,y" : "z";
  for (int k = 4; k <= d; ++k) text += fmt::format(",a{}", k);  // attributes beside the geometry
  text += ",u,v,error\n";
  for (Index k = 0; k < n; ++k) {
    const double u = points.u(k), v = points.v(k);
    const auto put = [&](double value, char then) {
      append_number(text, value);
      text += then;
    };
    const auto [a, b] = points.map.from_uv(u, v);
    if (height) {
      put(a, ',');
      put(b, ',');
    }
    for (int c = 0; c < d; ++c) put(points.value(k)[c], ',');
    // The user of a height field gave x and y and no other parameters: u, v are the surface's own.
    put(height ? u : a, ',');
    put(height ? v : b, ',');
    put(errors[static_cast<std::size_t>(k)], '\n');
    if (text.size() > 1 << 16) {
      out.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace knotfit
