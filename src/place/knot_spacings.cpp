#include "place/knot_spacings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
namespace knotfit {

void raise_lengths(std::vector<double>& length, double least) {
  const double floor = least / static_cast<double>(length.size());
  if (*std::min_element(length.begin(), length.end()) >= floor) return;
  for (int pass = 0; pass < 5; ++pass) {  // raising some shrinks the others, which may need it then
    double fixed = 0, free = 0;
    for (double h : length) h <= floor ? fixed += floor : free += h;
    for (double& h : length) h = h <= floor ? floor : h * (1 - fixed) / free;
  }
}

KnotSpacings::KnotSpacings(const std::vector<double>& knots) {
  double before = 0;
  for (double x : knots) {
    if (!multiplicity.empty() && x == before) {
      ++multiplicity.back();
      continue;
    }
    length.push_back(x - before);
    multiplicity.push_back(1);
    before = x;
  }
  length.push_back(1 - before);
}

std::vector<double> KnotSpacings::knots() const {
  std::vector<double> result;
  double at = 0;
  for (std::size_t i = 0; i < multiplicity.size(); ++i) {
    at += length[i];
    result.insert(result.end(), multiplicity[i], at);
  }
  return result;
}

std::size_t KnotSpacings::knot_count() const {
  return static_cast<std::size_t>(std::accumulate(multiplicity.begin(), multiplicity.end(), 0));
}

KnotSpacings KnotSpacings::moved(const double* step, double least) const {
  KnotSpacings result = *this;
  double sum = 0;
  for (std::size_t i = 0; i < length.size(); ++i) sum += result.length[i] *= std::exp(step[i]);
  for (double& h : result.length) h /= sum;
  raise_lengths(result.length, least);
  return result;
}

InteriorKnots moved_knots(const InteriorKnots& knots, const double* step, double least) {
  const KnotSpacings u(knots.u), v(knots.v);
  return {u.moved(step, least).knots(), v.moved(step + u.length.size(), least).knots()};
}

void KnotSpacings::chain(std::vector<double>& matrix, std::size_t row, std::size_t column,
                         std::size_t stride) const {
  double u = 0;
  for (std::size_t j = 0; j < multiplicity.size(); ++j) {
    u += length[j];
    for (int copy = 0; copy < multiplicity[j]; ++copy, ++row)
      for (std::size_t i = 0; i < length.size(); ++i)
        matrix[row * stride + column + i] = length[i] * ((i <= j ? 1.0 : 0.0) - u);
  }
}

}  // namespace knotfit
