#include "report/content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/exceptions.h"
namespace knotfit::report {
namespace {

void check(const PictureInput& input) {
  if (!input.surface || input.surface->empty())
    throw InvalidInput("a picture needs a surface, and none was given");
  const Index n = input.points ? input.points->size() : 0;
  if (input.points && input.points->uv.size() % 2 != 0)
    throw InvalidInput(
        "the points of a picture have an odd count of parameters; one (u, v) a point is needed");
  if (!input.signed_errors.empty() && static_cast<Index>(input.signed_errors.size()) != n)
    throw InvalidInput(fmt::format("{} errors for {} points: a picture needs one a point, or none",
                                   input.signed_errors.size(), n));
  for (Index k = 0; k < static_cast<Index>(input.signed_errors.size()); ++k)
    if (!std::isfinite(input.signed_errors[k]))
      throw InvalidInput(fmt::format("the error of point {} is not finite; it cannot be drawn", k));
  for (Index k = 0; k < n; ++k)
    if (!std::isfinite(input.points->u(k)) || !std::isfinite(input.points->v(k)))
      throw InvalidInput(fmt::format("point {} has parameters that are not finite", k));
  if (!(input.tolerance >= 0) || !std::isfinite(input.tolerance))
    throw InvalidInput(
        fmt::format("a picture's tolerance must be finite and at least 0, not {}", input.tolerance));
}

std::optional<DataBox> data_box(const PictureInput& input) {
  if (!input.points || input.points->size() == 0) return std::nullopt;
  const ParameterizedPoints& p = *input.points;
  if (p.dimension != input.surface->dimension() ||
      p.values.size() != static_cast<std::size_t>(p.size() * p.dimension))
    return std::nullopt;
  DataBox box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (Index k = 0; k < p.size(); ++k) {
    const double* v = p.value(k);
    const Vec3 at = p.dimension < 3 ? Vec3{0, 0, v[0]} : Vec3{v[0], v[1], v[2]};
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) return std::nullopt;
    box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y), std::min(box.low.z, at.z)};
    box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y), std::max(box.high.z, at.z)};
  }
  return box;
}

}  // namespace

std::optional<Rgb> Content::colour_at(double u, double v, double z) const {
  if (openings.inside(u, v)) return std::nullopt;
  switch (colouring) {
    case Colouring::error: {
      const std::optional<double> e = errors.at(u, v);
      return e ? std::optional<Rgb>(scale.colour(*e)) : std::nullopt;
    }
    case Colouring::height: {
      const double low = samples.low.z, high = samples.high.z;
      return sequential(samples.scale.z > 0 ? (z - low) / (high - low) : 0.5);
    }
    case Colouring::plain:
      break;
  }
  return kMaterial;
}

Content prepare(const PictureInput& input, int most) {
  check(input);
  Content c;
  c.input = &input;
  const Surface& s = *input.surface;
  c.domain = {s.knots_u().first(), s.knots_u().last(), s.knots_v().first(), s.knots_v().last()};
  if (input.points) c.map = input.points->map;
  if (!(c.map.u1 != c.map.u0) || !(c.map.v1 != c.map.v0) || !std::isfinite(c.map.u1 - c.map.u0) ||
      !std::isfinite(c.map.v1 - c.map.v0))
    throw InvalidInput("the parameter map of the points has an empty range; it cannot be drawn");
  c.point_count = input.points ? input.points->size() : 0;
  c.samples = sample_surface(s, c.map, most, data_box(input));
  c.thin = ThinField(input.thin_places, c.domain);
  for (const auto& t : input.openings)
    for (const double x : t)
      if (!std::isfinite(x)) throw InvalidInput("an opening of a picture has a corner that is not finite");
  c.openings = OpeningField(input.openings, c.domain);
  c.gaps = !c.openings.empty();
  if (input.signed_errors.empty()) {
    c.colouring = c.samples.height_field ? Colouring::height : Colouring::plain;
    return c;
  }
  c.colouring = Colouring::error;
  c.scale = error_scale(input.signed_errors, input.tolerance);
  c.errors = ErrorField(c.points(), input.signed_errors, c.domain);
  for (Index i = 0; i < 64 && !c.gaps; ++i)
    for (Index j = 0; j < 64 && !c.gaps; ++j)
      c.gaps = !c.errors.at(c.domain.u0 + (static_cast<double>(i) + 0.5) / 64 * (c.domain.u1 - c.domain.u0),
                            c.domain.v0 + (static_cast<double>(j) + 0.5) / 64 * (c.domain.v1 - c.domain.v0));
  const std::vector<double>& e = input.signed_errors;
  c.worst =
      std::max_element(e.begin(), e.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      e.begin();
  c.max = std::abs(e[c.worst]);
  if (c.max > 0) {  // squares of the ratio: no overflow, no underflow
    const double sum = parallel_sum<double>(c.point_count, [&](Index begin, Index end) {
      double part = 0;
      for (Index k = begin; k < end; ++k) part += (e[k] / c.max) * (e[k] / c.max);
      return part;
    });
    c.rms = c.max * std::sqrt(sum / static_cast<double>(c.point_count));
  }
  return c;
}

}  // namespace knotfit::report
