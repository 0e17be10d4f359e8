#include "data/orientation.h"

#include <cmath>
#include <limits>
namespace knotfit {
namespace {

// Sum of at most twelve doubles kept exactly as non-overlapping parts, least first [Shewchuk97, 2.4].
class ExactSum {
 public:
  void add(double x) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const double sum = part_[i] + x, back = sum - part_[i];
      const double error = (part_[i] - (sum - back)) + (x - back);
      if (error != 0) part_[kept++] = error;
      x = sum;
    }
    part_[kept++] = x;
    size_ = kept;
  }
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  int sign() const {  // the largest part outweighs all others together
    for (int i = size_ - 1; i >= 0; --i)
      if (part_[i] != 0) return part_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  double part_[16];
  int size_ = 0;
};

}  // namespace

int orientation(const double* a, const double* b, const double* c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double area = left - right;
  // Bound of the rounding errors of the line above [Shewchuk97, 4.3]: (3 + 16 eps) eps, eps = 2^-53.
  constexpr double eps = std::numeric_limits<double>::epsilon() / 2;
  const double bound = (3 + 16 * eps) * eps * (std::abs(left) + std::abs(right));
  if (area > bound) return 1;
  if (area < -bound) return -1;
  ExactSum sum;
  sum.add_product(a[0], b[1]);
  sum.add_product(-a[0], c[1]);
  sum.add_product(-a[1], b[0]);
  sum.add_product(a[1], c[0]);
  sum.add_product(b[0], c[1]);
  sum.add_product(-b[1], c[0]);
  return sum.sign();
}

Index count_flipped(std::span<const std::array<std::int32_t, 3>> faces, std::span<const double> uv) {
  Index flipped = 0;
  for (const auto& t : faces) flipped += orientation(&uv[2 * t[0]], &uv[2 * t[1]], &uv[2 * t[2]]) <= 0;
  return flipped;
}

}  // namespace knotfit
