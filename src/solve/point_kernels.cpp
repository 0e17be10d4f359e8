#include "solve/point_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/clones.h"

namespace knotfit {
namespace {

constexpr int kMostMoments = 2 * kMaxDegree + 2;
constexpr int kLanes = 8;  // points taken at once, side by side in vector registers

/// Counts of one pair of degrees; a static one lets the loops unroll.
template <int degree>
struct StaticCounts {
  static constexpr int qo = 2 * degree + 1, qi = qo, wo = degree + 1, wi = wo, stride = (qi + 3) / 4 * 4;
  static constexpr int most_moments = qi, most_width = wi;
};
struct DynamicCounts {
  int qo, qi, wo, wi, stride;
  static constexpr int most_moments = kMostMoments, most_width = kMaxDegree + 1;
  DynamicCounts(int o, int i) : qo(2 * o + 1), qi(2 * i + 1), wo(o + 1), wi(i + 1), stride(padded(qi)) {}
};

/// The Legendre values of kLanes points: value a of lane k at [a][k].
using Lanes = double[kMostMoments][kLanes];
[[gnu::always_inline]] inline void legendre_lanes(const double* t, int count, Lanes& p) {
  for (int k = 0; k < kLanes; ++k) p[0][k] = 1;
  for (int k = 0; k < kLanes; ++k) p[1][k] = t[k];
  for (int a = 2; a < count; ++a)
    for (int k = 0; k < kLanes; ++k)
      p[a][k] = kLegendre.alpha[a] * t[k] * p[a - 1][k] - kLegendre.beta[a] * p[a - 2][k];
}

/// Local coordinates of the points from `begin`, the last repeated past the piece's end.
/// \return how many are the piece's
[[gnu::always_inline]] inline int load_lanes(const CellOrder& order, Index begin, Index end, double* t,
                                             double* s) {
  const int count = static_cast<int>(std::min<Index>(kLanes, end - begin));
  for (int k = 0; k < kLanes; ++k) {
    t[k] = order.outer(begin + std::min(k, count - 1));
    s[k] = order.inner(begin + std::min(k, count - 1));
  }
  return count;
}

/// 8 points side by side. (GCC and Clang split it into what the instruction set has.)
typedef double Vector __attribute__((vector_size(kLanes * sizeof(double))));
constexpr int kBatch = 128, kGroups = kBatch / kLanes;  // points taken at once, and vectors of them

/// Up to kBatch points of a piece: Legendre values P_a of either coordinate as p[a][group], and x, which is 0
/// past the piece's end.
struct PointBatch {
  Vector p[kMostMoments][kGroups], q[kMostMoments][kGroups], x[kGroups], weight[kGroups];
  int count = 0, groups = 0;

  [[gnu::always_inline]] void load(const CellOrder& order, Index begin, Index end, int rows, int columns) {
    count = static_cast<int>(std::min<Index>(kBatch, end - begin));
    groups = (count + kLanes - 1) / kLanes;
    for (int k = 0; k < groups * kLanes; ++k) {
      const Index i = begin + std::min(k, count - 1);
      p[1][k / kLanes][k % kLanes] = order.outer(i);
      q[1][k / kLanes][k % kLanes] = order.inner(i);
      weight[k / kLanes][k % kLanes] = k < count ? order.weight(i) : 0;
    }
    recur(p, rows);
    recur(q, columns);
  }
  [[gnu::always_inline]] void recur(Vector (&values)[kMostMoments][kGroups], int count_of_values) {
    for (int g = 0; g < groups; ++g) values[0][g] = Vector{} + 1.0;
    for (int a = 2; a < count_of_values; ++a)
      for (int g = 0; g < groups; ++g)
        values[a][g] =
            kLegendre.alpha[a] * values[1][g] * values[a - 1][g] - kLegendre.beta[a] * values[a - 2][g];
  }
  /// Adds sum x P_a Q_b to sums[a * stride + b], the lanes first, then these in a fixed order.
  template <int most>
  [[gnu::always_inline]] void add_sums(int rows, int columns, int stride, double* sums) const {
    for (int a = 0; a < rows; ++a) {
      Vector sum[most] = {};
      for (int g = 0; g < groups; ++g) {
        const Vector xp = x[g] * p[a][g];
        for (int b = 0; b < columns; ++b) sum[b] += xp * q[b][g];
      }
      for (int b = 0; b < columns; ++b) {
        const Vector& v = sum[b];
        sums[a * stride + b] += ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
      }
    }
  }
};

template <class Counts>
[[gnu::always_inline]] inline void moments(const Counts& n, const CellOrder& order, const CellPiece& piece,
                                           double* matrix, double* rhs) {
  const int dimension = order.dimension();
  PointBatch batch;
  for (Index begin = piece.begin; begin < piece.end; begin += kBatch) {
    batch.load(order, begin, piece.end, n.qo, n.qi);
    for (int g = 0; g < batch.groups; ++g) batch.x[g] = batch.weight[g];
    batch.add_sums<Counts::most_moments>(n.qo, n.qi, n.stride, matrix);
    for (int e = 0; e < dimension; ++e) {
      for (int k = 0; k < batch.count; ++k)
        batch.x[k / kLanes][k % kLanes] = batch.weight[k / kLanes][k % kLanes] * order.value(begin + k)[e];
      batch.add_sums<Counts::most_width>(n.wo, n.wi, n.wi, rhs + e * n.wo * n.wi);
    }
  }
}

template <class Counts>
[[gnu::always_inline]] inline void rhs_moments(const Counts& n, const CellOrder& order,
                                               const CellPiece& piece, const double* values, double* rhs) {
  const int dimension = order.dimension();
  PointBatch batch;
  for (Index begin = piece.begin; begin < piece.end; begin += kBatch) {
    batch.load(order, begin, piece.end, n.wo, n.wi);
    for (int g = 0; g < batch.groups; ++g) batch.x[g] = batch.weight[g];
    for (int e = 0; e < dimension; ++e) {
      for (int k = 0; k < batch.count; ++k)
        batch.x[k / kLanes][k % kLanes] =
            batch.weight[k / kLanes][k % kLanes] * values[order.stored(begin + k) * dimension + e];
      batch.add_sums<Counts::most_width>(n.wo, n.wi, n.wi, rhs + e * n.wo * n.wi);
    }
  }
}

template <class Counts>
[[gnu::always_inline]] inline ResidualSums residuals(const Counts& n, const CellOrder& order,
                                                     const CellPiece& piece, Index counted, const double* c,
                                                     double* x) {
  const int dimension = order.dimension();
  const bool all_count = counted >= order.size();
  ResidualSums sums;
  alignas(64) Lanes p, q;
  alignas(64) double t[kLanes], s[kLanes], sum[kLanes], row[kLanes], square[kLanes];
  for (Index begin = piece.begin; begin < piece.end; begin += kLanes) {
    const int count = load_lanes(order, begin, piece.end, t, s);
    legendre_lanes(t, n.wo, p);
    legendre_lanes(s, n.wi, q);
    for (int k = 0; k < kLanes; ++k) square[k] = 0;
    for (int e = 0; e < dimension; ++e) {
      const double* ce = c + e * n.wo * n.wi;
      for (int k = 0; k < kLanes; ++k) sum[k] = 0;
      for (int a = 0; a < n.wo; ++a) {
        for (int k = 0; k < kLanes; ++k) row[k] = 0;
        for (int b = 0; b < n.wi; ++b)
          for (int k = 0; k < kLanes; ++k) row[k] += ce[a * n.wi + b] * q[b][k];
        for (int k = 0; k < kLanes; ++k) sum[k] += row[k] * p[a][k];
      }
      for (int k = 0; k < count; ++k) {
        const double r = sum[k] - order.value(begin + k)[e];
        x[order.stored(begin + k) * dimension + e] = r;
        square[k] += r * r;
      }
    }
    for (int k = 0; k < count; ++k) {
      sums.weighted += order.weight(begin + k) * square[k];
      if (!all_count && order.input(order.stored(begin + k)) >= counted) continue;
      sums.squares += square[k];
      if (!(square[k] <= sums.max)) sums.max = square[k];  // a NaN stays
    }
  }
  return sums;
}

// One clone a kernel, so that the inlined loops are compiled for each instruction set.
#define KNOTFIT_KERNEL(result, name, loop, params, args) \
  KNOTFIT_CLONES result name##_1 params {                \
    return loop(StaticCounts<1>{}, args);                \
  }                                                      \
  KNOTFIT_CLONES result name##_2 params {                \
    return loop(StaticCounts<2>{}, args);                \
  }                                                      \
  KNOTFIT_CLONES result name##_3 params {                \
    return loop(StaticCounts<3>{}, args);                \
  }                                                      \
  KNOTFIT_CLONES result name##_4 params {                \
    return loop(StaticCounts<4>{}, args);                \
  }                                                      \
  KNOTFIT_CLONES result name##_5 params {                \
    return loop(StaticCounts<5>{}, args);                \
  }
#define KNOTFIT_ARGS(...) __VA_ARGS__

KNOTFIT_KERNEL(void, moments_kernel, moments, (const CellOrder& o, const CellPiece& p, double* m, double* r),
               KNOTFIT_ARGS(o, p, m, r))
KNOTFIT_KERNEL(void, rhs_kernel, rhs_moments,
               (const CellOrder& o, const CellPiece& p, const double* x, double* r), KNOTFIT_ARGS(o, p, x, r))
KNOTFIT_KERNEL(ResidualSums, residual_kernel, residuals,
               (const CellOrder& o, const CellPiece& p, Index n, const double* c, double* x),
               KNOTFIT_ARGS(o, p, n, c, x))

}  // namespace

void add_moments(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                 double* matrix, double* rhs) {
  constexpr std::array kernels{moments_kernel_1, moments_kernel_2, moments_kernel_3, moments_kernel_4,
                               moments_kernel_5};
  if (degree_outer == degree_inner && degree_outer <= 5)
    kernels[degree_outer - 1](order, piece, matrix, rhs);
  else
    moments(DynamicCounts(degree_outer, degree_inner), order, piece, matrix, rhs);
}

void add_rhs_moments(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                     const double* x, double* rhs) {
  constexpr std::array kernels{rhs_kernel_1, rhs_kernel_2, rhs_kernel_3, rhs_kernel_4, rhs_kernel_5};
  if (degree_outer == degree_inner && degree_outer <= 5)
    kernels[degree_outer - 1](order, piece, x, rhs);
  else
    rhs_moments(DynamicCounts(degree_outer, degree_inner), order, piece, x, rhs);
}

ResidualSums set_residuals(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                           Index counted, const double* c, double* x) {
  constexpr std::array kernels{residual_kernel_1, residual_kernel_2, residual_kernel_3, residual_kernel_4,
                               residual_kernel_5};
  if (degree_outer == degree_inner && degree_outer <= 5)
    return kernels[degree_outer - 1](order, piece, counted, c, x);
  return residuals(DynamicCounts(degree_outer, degree_inner), order, piece, counted, c, x);
}

}  // namespace knotfit
