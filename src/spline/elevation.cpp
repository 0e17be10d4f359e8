#include "spline/elevation.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "spline/insertion.h"
namespace knotfit {
namespace {

/// One degree more [Prautzsch84; Piegl97 5.5]. With q = degree + 1 and A the elevated knots without the outermost
/// two, the control point of arguments A_i .. A_{i+q-1} is the mean of q blossoms that leave one argument out.
/// Those that leave out an index = s mod q are the control points of S over A without these indices: q
/// refinements of S, and only convex combinations.
Surface elevated_once(const Surface& s) {
  const KnotVector& knots = s.knots_u();
  const Index q = knots.degree() + 1;
  std::vector<double> elevated;
  for (const double at : knots.breaks()) {
    const bool end = at == knots.first() || at == knots.last();
    elevated.insert(elevated.end(), static_cast<std::size_t>(end ? q + 1 : knots.multiplicity(at) + 1), at);
  }
  const std::vector<double> arguments(elevated.begin() + 1, elevated.end() - 1);
  const KnotVector result(static_cast<int>(q), std::move(elevated));
  const Index width = s.size_v() * s.dimension(), size = result.size();
  std::vector<double> net(static_cast<std::size_t>(size * width), 0.0);
  for (Index omitted = 0; omitted < q; ++omitted) {
    std::vector<double> kept = {arguments.front()};  // clamped: the outermost knots take no part
    for (Index k = 0; k < static_cast<Index>(arguments.size()); ++k)
      if (k % q != omitted) kept.push_back(arguments[k]);
    kept.push_back(arguments.back());
    // What S lacks of these knots: the ends have all they need.
    std::vector<double> added;
    std::set_difference(kept.begin(), kept.end(), knots.knots().begin(), knots.knots().end(),
                        std::back_inserter(added));
    const RefinedPoints part = refine_points(knots, added, s.net(), 1, width);
    for (Index i = 0; i < size; ++i) {
      const Index left_out_before = (i + q - 1 - omitted) / q;  // indices below i that are = omitted mod q
      const double* from = part.points.data() + (i - left_out_before) * width;
      for (Index c = 0; c < width; ++c) net[i * width + c] += from[c];
    }
  }
  for (double& c : net) c /= static_cast<double>(q);
  std::copy_n(s.net().begin(), width, net.begin());  // corners and borders keep their bits
  std::copy_n(s.net().end() - width, width, net.end() - width);
  return Surface(result, s.knots_v(), s.dimension(), std::move(net));
}

}  // namespace

Surface elevated_u(const Surface& s, int degree) {
  if (s.empty()) throw InvalidInput("the surface to raise the degree of is empty");
  if (degree < s.degree_u() || degree > kMaxDegree)
    throw InvalidInput(fmt::format("degree {} cannot be raised to {}", s.degree_u(), degree));
  if (!s.knots_u().is_clamped()) throw InvalidInput("the surface to raise the degree of is not clamped");
  for (const double knot : s.knots_u().interior())
    if (s.knots_u().multiplicity(knot) > s.degree_u())
      throw InvalidInput(fmt::format("the surface to raise the degree of jumps at {}", knot));
  Surface result = s;
  while (result.degree_u() < degree) result = elevated_once(result);
  return result;
}

}  // namespace knotfit
