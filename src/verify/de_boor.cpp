#include "verify/de_boor.h"

#include <algorithm>
#include <cmath>
namespace knotfit::verify {

Triangle::Triangle(const KnotVector& knots, double x) : degree_(knots.degree()) {
  const std::vector<double>& t = knots.knots();
  const double first = t[degree_], last = t[t.size() - 1 - degree_];
  x = std::clamp(x, first, last);
  // The span t_s <= x < t_{s+1}; at the right end the last one that is not empty.
  Index s = std::upper_bound(t.begin() + degree_, t.end() - degree_ - 1, x) - t.begin() - 1;
  while (s > degree_ && t[s] == t[s + 1]) --s;
  first_ = s - degree_;
  for (int r = 1; r <= degree_; ++r)
    for (int j = degree_; j >= r; --j) {
      const double low = t[first_ + j], high = t[first_ + j + degree_ - r + 1];
      alpha_[r - 1][j] = (x - low) / (high - low);  // the interval holds the span: not empty
    }
}

double Triangle::value(double* c) const {
  for (int r = 1; r <= degree_; ++r)
    for (int j = degree_; j >= r; --j) {
      const double a = alpha_[r - 1][j];
      c[j] = (1 - a) * c[j - 1] + a * c[j];
    }
  return c[degree_];
}

void de_boor(const Surface& surface, double u, double v, std::span<double> out) {
  const Triangle along_u(surface.knots_u(), u), along_v(surface.knots_v(), v);
  const double* net = surface.net().data();
  const Index size_v = surface.size_v();
  const int dimension = surface.dimension();
  double column[kMaxDegree + 1], row[kMaxDegree + 1];
  for (int d = 0; d < dimension; ++d) {
    for (int i = 0; i <= along_u.degree(); ++i) {
      for (int j = 0; j <= along_v.degree(); ++j)
        row[j] = net[((along_u.first() + i) * size_v + along_v.first() + j) * dimension + d];
      column[i] = along_v.value(row);
    }
    out[d] = along_u.value(column);
  }
}

double distance(std::span<const double> a, std::span<const double> b) {
  if (a.size() == 1) return std::abs(a[0] - b[0]);
  double sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  if (sum > 1e-280 && sum < 1e280) return std::sqrt(sum);
  double largest = 0;
  for (std::size_t d = 0; d < a.size(); ++d) {
    if (!std::isfinite(a[d] - b[d])) return std::abs(a[d] - b[d]);
    largest = std::max(largest, std::abs(a[d] - b[d]));
  }
  if (largest == 0) return 0;
  sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) / largest * ((a[d] - b[d]) / largest);
  return largest * std::sqrt(sum);
}

}  // namespace knotfit::verify
