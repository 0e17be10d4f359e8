#include "fit/kernels.h"

#include <array>

// The vector width never shows in a result: products and sums stay separate (-ffp-contract=off) and
// no loop over points is reordered.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(KNOTFIT_SANITIZED)
#define KNOTFIT_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define KNOTFIT_CLONES
#endif

namespace knotfit {
namespace {

constexpr int kMostMoments = 2 * kMaxDegree + 2, kPadded = 20;

/// Counts of one pair of degrees; a static one lets the loops unroll.
template <int degree>
struct StaticCounts {
  static constexpr int qo = 2 * degree + 1, qi = qo, wo = degree + 1, wi = wo, stride = (qi + 3) / 4 * 4;
};
struct DynamicCounts {
  int qo, qi, wo, wi, stride;
  DynamicCounts(int o, int i) : qo(2 * o + 1), qi(2 * i + 1), wo(o + 1), wi(i + 1), stride(padded(qi)) {}
};

template <class Counts>
[[gnu::always_inline]] inline void moments(const Counts& n, const CellOrder& order, const CellPiece& piece,
                                           double* matrix, double* rhs) {
  alignas(32) double p[kMostMoments], q[kPadded] = {};
  const int dimension = order.dimension();
  for (Index k = piece.begin; k < piece.end; ++k) {
    legendre_values(order.outer(k), n.qo, p);
    legendre_values(order.inner(k), n.qi, q);
    const double w = order.weight(k);
    for (int a = 0; a < n.qo; ++a) {
      const double wp = w * p[a];
      for (int b = 0; b < n.stride; ++b) matrix[a * n.stride + b] += wp * q[b];
    }
    const double* x = order.value(k);
    for (int e = 0; e < dimension; ++e) {
      const double wx = w * x[e];
      double* r = rhs + e * n.wo * n.wi;
      for (int a = 0; a < n.wo; ++a) {
        const double wp = wx * p[a];
        for (int b = 0; b < n.wi; ++b) r[a * n.wi + b] += wp * q[b];
      }
    }
  }
}

template <class Counts>
[[gnu::always_inline]] inline void rhs_moments(const Counts& n, const CellOrder& order,
                                               const CellPiece& piece, const double* x, double* rhs) {
  double p[kMostMoments], q[kMostMoments];
  const int dimension = order.dimension();
  for (Index k = piece.begin; k < piece.end; ++k) {
    legendre_values(order.outer(k), n.wo, p);
    legendre_values(order.inner(k), n.wi, q);
    const double w = order.weight(k);
    for (int e = 0; e < dimension; ++e) {
      const double wx = w * x[order.stored(k) * dimension + e];
      double* r = rhs + e * n.wo * n.wi;
      for (int a = 0; a < n.wo; ++a) {
        const double wp = wx * p[a];
        for (int b = 0; b < n.wi; ++b) r[a * n.wi + b] += wp * q[b];
      }
    }
  }
}

template <class Counts>
[[gnu::always_inline]] inline void residuals(const Counts& n, const CellOrder& order, const CellPiece& piece,
                                             const double* c, double* x) {
  double p[kMostMoments], q[kMostMoments];
  const int dimension = order.dimension();
  for (Index k = piece.begin; k < piece.end; ++k) {
    legendre_values(order.outer(k), n.wo, p);
    legendre_values(order.inner(k), n.wi, q);
    const double* value = order.value(k);
    for (int e = 0; e < dimension; ++e) {
      const double* ce = c + e * n.wo * n.wi;
      double sum = 0;
      for (int a = 0; a < n.wo; ++a) {
        double row = 0;
        for (int b = 0; b < n.wi; ++b) row += ce[a * n.wi + b] * q[b];
        sum += row * p[a];
      }
      x[order.stored(k) * dimension + e] = sum - value[e];
    }
  }
}

// One clone a kernel, so that the inlined loops are compiled for each instruction set.
#define KNOTFIT_KERNEL(name, loop, params, args) \
  KNOTFIT_CLONES void name##_1 params {          \
    loop(StaticCounts<1>{}, args);               \
  }                                              \
  KNOTFIT_CLONES void name##_2 params {          \
    loop(StaticCounts<2>{}, args);               \
  }                                              \
  KNOTFIT_CLONES void name##_3 params {          \
    loop(StaticCounts<3>{}, args);               \
  }                                              \
  KNOTFIT_CLONES void name##_4 params {          \
    loop(StaticCounts<4>{}, args);               \
  }                                              \
  KNOTFIT_CLONES void name##_5 params {          \
    loop(StaticCounts<5>{}, args);               \
  }
#define KNOTFIT_ARGS(...) __VA_ARGS__

KNOTFIT_KERNEL(moments_kernel, moments, (const CellOrder& o, const CellPiece& p, double* m, double* r),
               KNOTFIT_ARGS(o, p, m, r))
KNOTFIT_KERNEL(rhs_kernel, rhs_moments, (const CellOrder& o, const CellPiece& p, const double* x, double* r),
               KNOTFIT_ARGS(o, p, x, r))
KNOTFIT_KERNEL(residual_kernel, residuals,
               (const CellOrder& o, const CellPiece& p, const double* c, double* x), KNOTFIT_ARGS(o, p, c, x))

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

void add_residuals(const CellOrder& order, const CellPiece& piece, int degree_outer, int degree_inner,
                   const double* c, double* x) {
  constexpr std::array kernels{residual_kernel_1, residual_kernel_2, residual_kernel_3, residual_kernel_4,
                               residual_kernel_5};
  if (degree_outer == degree_inner && degree_outer <= 5)
    kernels[degree_outer - 1](order, piece, c, x);
  else
    residuals(DynamicCounts(degree_outer, degree_inner), order, piece, c, x);
}

}  // namespace knotfit
