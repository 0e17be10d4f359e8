#include "knotfit/knot_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

void check_degree(int degree) {
  if (degree < 1 || degree > kMaxDegree)
    throw InvalidInput(fmt::format("degree {} is outside [1, {}]", degree, kMaxDegree));
}

void check_knots(int degree, const std::vector<double>& knots) {
  check_degree(degree);
  const std::size_t least = 2 * (static_cast<std::size_t>(degree) + 1);
  if (knots.size() < least)
    throw InvalidInput(fmt::format("a knot vector of degree {} needs at least {} knots; there are {}", degree,
                                   least, knots.size()));
  std::size_t run = 0;  // where the present run of equal knots began
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]))
      throw InvalidInput(fmt::format("knot {} is {}; knots must be finite", i, knots[i]));
    if (i == 0) continue;
    if (knots[i] < knots[i - 1])
      throw InvalidInput(fmt::format("knot {} ({}) is less than knot {} ({}); sort the knots", i, knots[i],
                                     i - 1, knots[i - 1]));
    if (knots[i] != knots[i - 1]) run = i;
    if (i - run > static_cast<std::size_t>(degree))
      throw InvalidInput(
          fmt::format("knot {} ({}) has a multiplicity above degree + 1 = {}", i, knots[i], degree + 1));
  }
  const double first = knots[static_cast<std::size_t>(degree)];
  const double last = knots[knots.size() - 1 - static_cast<std::size_t>(degree)];
  if (!(first < last))
    throw InvalidInput(fmt::format("the domain [{}, {}] of the knots is empty", first, last));
  if (!std::isfinite(knots.back() - knots.front()))
    throw InvalidInput(
        fmt::format("the knots span [{}, {}], too far apart for their differences to be numbers",
                    knots.front(), knots.back()));
}

void check_interior(double knot, std::size_t i, double first, double last) {
  if (!(knot > first && knot < last))
    throw InvalidInput(fmt::format("interior knot {} ({}) is not inside ({}, {})", i, knot, first, last));
}

}  // namespace

KnotVector::KnotVector(int degree, std::vector<double> knots) : degree_(degree), knots_(std::move(knots)) {
  check_knots(degree_, knots_);
}

KnotVector KnotVector::clamped(int degree, std::span<const double> interior, double first, double last) {
  check_degree(degree);
  if (!std::isfinite(first) || !std::isfinite(last) || !(first < last))
    throw InvalidInput(fmt::format("the domain [{}, {}] of the knots is empty or not finite", first, last));
  for (std::size_t i = 0; i < interior.size(); ++i) {
    check_interior(interior[i], i, first, last);
    if (i > 0 && interior[i] < interior[i - 1])
      throw InvalidInput(fmt::format("interior knot {} ({}) is less than the one before ({}); sort the knots",
                                     i, interior[i], interior[i - 1]));
  }
  const std::size_t ends = static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(ends, first);
  knots.reserve(interior.size() + 2 * ends);
  knots.insert(knots.end(), interior.begin(), interior.end());
  knots.insert(knots.end(), ends, last);
  return KnotVector(degree, std::move(knots));
}

KnotVector KnotVector::uniform(int degree, int interior, double first, double last) {
  if (interior < 0)
    throw InvalidInput(fmt::format("the number of interior knots is {}; it must be >= 0", interior));
  std::vector<double> knots(static_cast<std::size_t>(interior));
  for (int i = 0; i < interior; ++i) {
    const double part = (i + 1.0) / (interior + 1.0);
    knots[static_cast<std::size_t>(i)] = first == 0 && last == 1 ? part : (1 - part) * first + part * last;
  }
  return clamped(degree, knots, first, last);
}

bool KnotVector::is_clamped() const {
  return !knots_.empty() && knots_.front() == first() && knots_.back() == last();
}

Index KnotVector::find_span(double x) const {
  const double* const t = knots_.data();
  // The last span is closed: at its end, the span that ends there.
  if (x >= last()) return std::lower_bound(t + degree_, t + size(), last()) - t - 1;
  if (!(x > first())) x = first();  // a NaN, too, must land in a span that exists
  // Last knot <= x, without branches that random parameters would mispredict.
  const double* at = t + degree_;
  for (Index left = size() - degree_; left > 1;) {
    const Index half = left / 2;
    at += at[half] <= x ? half : 0;
    left -= half;
  }
  return at - t;
}

Index KnotVector::span_count() const {
  Index count = 0;
  for (Index i = degree_; i < size(); ++i) count += (*this)[i] < (*this)[i + 1];
  return count;
}

std::vector<double> KnotVector::breaks() const {
  std::vector<double> result;
  std::unique_copy(knots_.begin() + degree_, knots_.end() - degree_, std::back_inserter(result));
  return result;
}

std::vector<double> KnotVector::interior() const {
  return {std::upper_bound(knots_.begin(), knots_.end(), first()),
          std::lower_bound(knots_.begin(), knots_.end(), last())};
}

int KnotVector::multiplicity(double knot) const {
  const auto [begin, end] = std::equal_range(knots_.begin(), knots_.end(), knot);
  return static_cast<int>(end - begin);
}

std::vector<double> KnotVector::greville() const {
  std::vector<double> result(static_cast<std::size_t>(size()));
  for (Index i = 0; i < size(); ++i) {
    // As a mean offset, so that equal knots give themselves exactly.
    const double base = (*this)[i + 1];
    double offset = 0;
    for (int k = 2; k <= degree_; ++k) offset += (*this)[i + k] - base;
    result[static_cast<std::size_t>(i)] = base + offset / degree_;
  }
  return result;
}

KnotVector merge(const KnotVector& a, const KnotVector& b) {
  if (a.degree() != b.degree())
    throw InvalidInput(
        fmt::format("knot vectors of degrees {} and {} cannot be merged", a.degree(), b.degree()));
  if (a.first() != b.first() || a.last() != b.last())
    throw InvalidInput(fmt::format("knot vectors with domains [{}, {}] and [{}, {}] cannot be merged",
                                   a.first(), a.last(), b.first(), b.last()));
  const auto &ka = a.knots(), &kb = b.knots();
  // The first and last degree + 1 knots fix the ends; merging different ones would move the domain.
  const int ends = a.degree() + 1;
  if (!std::equal(ka.begin(), ka.begin() + ends, kb.begin()) ||
      !std::equal(ka.end() - ends, ka.end(), kb.end() - ends))
    throw InvalidInput("knot vectors with different knots outside their domain cannot be merged; clamp both");
  std::vector<double> knots(ka.begin(), ka.begin() + ends);
  std::set_union(ka.begin() + ends, ka.end() - ends, kb.begin() + ends, kb.end() - ends,
                 std::back_inserter(knots));
  knots.insert(knots.end(), ka.end() - ends, ka.end());
  return KnotVector(a.degree(), std::move(knots));
}

}  // namespace knotfit
