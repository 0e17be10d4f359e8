#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "knotfit/remedy.h"
#include "parameterize/table_checks.h"
namespace knotfit {
namespace {

using Group = std::vector<Index>;  // points of equal parameters, in input order

constexpr std::size_t kExact = 256;  // larger groups: the distance of two far points for the largest of all

// Groups of two or more, in order of their first point. O(N log N).
std::vector<Group> equal_parameters(const ParameterizedPoints& points) {
  struct Keyed {
    double u, v;
    Index k;
  };
  std::vector<Keyed> sorted(static_cast<std::size_t>(points.size()));
  for (Index k = 0; k < points.size(); ++k) sorted[k] = {points.u(k), points.v(k), k};
  std::sort(sorted.begin(), sorted.end(), [](const Keyed& a, const Keyed& b) {
    return a.u != b.u ? a.u < b.u : a.v != b.v ? a.v < b.v : a.k < b.k;
  });
  std::vector<Group> groups;
  for (std::size_t i = 0, j; i < sorted.size(); i = j) {
    for (j = i + 1; j < sorted.size() && sorted[j].u == sorted[i].u && sorted[j].v == sorted[i].v;) ++j;
    if (j - i < 2) continue;
    groups.emplace_back();
    for (std::size_t k = i; k < j; ++k) groups.back().push_back(sorted[k].k);
  }
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a[0] < b[0]; });
  return groups;
}

double apart(const ParameterizedPoints& points, Index a, Index b) {
  double norm = 0;
  for (int d = 0; d < points.dimension; ++d) norm = std::hypot(norm, points.value(a)[d] - points.value(b)[d]);
  return norm;
}

// Largest distance of two points of a group.
double diameter(const ParameterizedPoints& points, const Group& group) {
  double most = 0;
  if (group.size() <= kExact && points.dimension > 1) {
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) most = std::max(most, apart(points, group[i], group[j]));
    return most;
  }
  // The farthest from the farthest: exact in one dimension, else at least 1/sqrt(3) of the largest.
  Index from = group[0];
  for (int round = 0; round < 3; ++round) {
    Index best = from;
    for (Index k : group)
      if (apart(points, from, k) > most) most = apart(points, from, k), best = k;
    from = best;
  }
  return most;
}

void check(const ParameterizedPoints& points, const std::vector<Group>& groups, double tolerance) {
  const Group* first = nullptr;
  double first_apart = 0;
  Index offending = 0;
  for (const Group& group : groups) {
    const double most = diameter(points, group);
    if (!(most > 2 * tolerance)) continue;
    if (offending++ == 0) first = &group, first_apart = most;
  }
  if (offending == 0) return;
  const ParameterMap& map = points.map;
  const auto at = map.from_uv(points.u(first->front()), points.v(first->front()));
  std::string message = fmt::format(
      "{} have equal parameters, {} = {} and {} = {}, but values up to {:.6g} apart: more than twice the "
      "tolerance {:.6g}, "
      "so that no surface can meet it",
      parameterize::point_names(points.source, *first), map.name_u, at[0], map.name_v, at[1], first_apart,
      tolerance);
  if (offending > 1) message += fmt::format(" (and {} more such groups)", offending - 1);
  throw InvalidInput(message + "; " + remedy_text(Remedy::duplicates, "mean") +
                     ", lowest or highest settles it");
}

// Weighted mean into the group's first point, as a step from its value so that large offsets keep their digits.
void merge(ParameterizedPoints& points, const Group& group) {
  const Index first = group[0];
  double weight = 0;
  for (Index k : group) weight += points.weight(k);
  for (int d = 0; d < points.dimension; ++d) {
    double step = 0;
    for (Index k : group) step += points.weight(k) / weight * (points.value(k)[d] - points.value(first)[d]);
    points.values[first * points.dimension + d] += step;
  }
  points.weights[first] = weight;
}

// The point of lowest or highest last component takes the place of the group's first.
void choose(ParameterizedPoints& points, const Group& group, bool lowest) {
  const int d = points.dimension;
  Index chosen = group[0];
  for (Index k : group) {
    const double z = points.value(k)[d - 1], best = points.value(chosen)[d - 1];
    if (lowest ? z < best : z > best) chosen = k;
  }
  if (chosen == group[0]) return;
  std::copy_n(points.values.begin() + chosen * d, d, points.values.begin() + group[0] * d);
  if (!points.weights.empty()) points.weights[group[0]] = points.weights[chosen];
  points.source[group[0]] = points.source[chosen];
}

void drop(ParameterizedPoints& points, const std::vector<char>& dropped) {
  const int d = points.dimension;
  Index to = 0;
  for (Index k = 0; k < static_cast<Index>(dropped.size()); ++k) {
    if (dropped[k]) continue;
    std::copy_n(points.uv.begin() + 2 * k, 2, points.uv.begin() + 2 * to);
    std::copy_n(points.values.begin() + k * d, d, points.values.begin() + to * d);
    if (!points.weights.empty()) points.weights[to] = points.weights[k];
    points.source[to] = points.source[k];
    ++to;
  }
  const auto size = static_cast<std::size_t>(to);
  points.uv.resize(2 * size);
  points.values.resize(size * static_cast<std::size_t>(d));
  if (!points.weights.empty()) points.weights.resize(size);
  points.source.resize(size);
}

}  // namespace

Index settle_duplicates(ParameterizedPoints& points, DuplicateRule rule, double tolerance) {
  validate(points);
  if (rule == DuplicateRule::fail && !(tolerance > 0)) return 0;
  const std::vector<Group> groups = equal_parameters(points);
  if (rule == DuplicateRule::fail) {
    check(points, groups, tolerance);
    return 0;
  }
  if (groups.empty()) return 0;
  const auto n = static_cast<std::size_t>(points.size());
  if (points.source.empty()) {
    points.source.resize(n);
    std::iota(points.source.begin(), points.source.end(), Index{1});
  }
  if (rule == DuplicateRule::mean && points.weights.empty()) points.weights.assign(n, 1);
  std::vector<char> dropped(n, 0);
  Index count = 0;
  for (const Group& group : groups) {
    if (rule == DuplicateRule::mean)
      merge(points, group);
    else
      choose(points, group, rule == DuplicateRule::lowest);
    for (std::size_t i = 1; i < group.size(); ++i) dropped[group[i]] = 1, ++count;
  }
  drop(points, dropped);
  return count;
}

}  // namespace knotfit
