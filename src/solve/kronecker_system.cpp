#include "solve/kronecker_system.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/basis.h"
namespace knotfit {

KroneckerSystem::KroneckerSystem(const ParameterizedPoints& points, GridLayout grid)
    : dimension_(points.dimension), grid_(std::move(grid)) {
  values_.resize(points.values.size());
  for (std::size_t k = 0; k < grid_.point.size(); ++k)
    std::copy_n(points.value(grid_.point[k]), dimension_, values_.begin() + k * dimension_);
}

void KroneckerSystem::arrange(Direction& direction, const Axis& axis, const std::vector<double>& lines) {
  const int w = axis.width();
  direction.width = w;
  direction.functions = axis.functions();
  direction.first.resize(lines.size());
  direction.values.resize(lines.size() * w);
  std::vector<char> used(axis.spans(), 0);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Index s = axis.span(lines[k]);
    used[s] = 1;
    direction.first[k] = s;
    basis_functions(axis.knots(), s + axis.degree(), lines[k],
                    {direction.values.data() + k * w, static_cast<std::size_t>(w)});
  }
  direction.used_spans = direction.empty_spans = 0;
  for (Index s = 0; s < axis.spans(); ++s)
    if (axis.length(s) > 0) ++(used[s] ? direction.used_spans : direction.empty_spans);
}

bool KroneckerSystem::factor(Direction& direction, const Axis& axis, double relative) {
  const int w = direction.width;
  direction.matrix.reset(axis.functions(), axis.degree());
  for (std::size_t k = 0; k < direction.first.size(); ++k) {
    const Index s = direction.first[k];
    const double* b = direction.values.data() + k * w;
    for (int i = 0; i < w; ++i)
      for (int j = 0; j <= i; ++j) direction.matrix.add(s + i, s + j, b[i] * b[j]);
  }
  const std::vector<double> energy = axis.gram(std::min(2, axis.degree()));
  double trace = 0;
  for (Index i = 0; i < axis.functions(); ++i) trace += energy[i * w];
  direction.smoothing = trace > 0 ? relative * direction.matrix.trace() / trace : 0;
  for (Index i = 0; i < axis.functions(); ++i)
    for (Index k = 0; k < std::min<Index>(w, i + 1); ++k)
      direction.matrix.add(i, i - k, direction.smoothing * energy[i * w + k]);
  if (keep_norm_) direction.norm = direction.matrix.norm_1();
  return direction.matrix.factor();
}

void KroneckerSystem::arrange(const Axis& u, const Axis& v) {
  arrange(u_, u, grid_.u);
  arrange(v_, v, grid_.v);
}

bool KroneckerSystem::factor(const Axis& u, const Axis& v, double relative_smoothing) {
  arrange(u, v);
  if (!factor(u_, u, relative_smoothing) || !factor(v_, v, relative_smoothing)) return false;
  smoothing_ = std::max(u_.smoothing, v_.smoothing);
  empty_cells_ =
      (u_.used_spans + u_.empty_spans) * (v_.used_spans + v_.empty_spans) - u_.used_spans * v_.used_spans;
  return true;
}

std::vector<double> KroneckerSystem::project(const std::vector<double>& x) const {
  const Index lines_u = static_cast<Index>(grid_.u.size()), lines_v = static_cast<Index>(grid_.v.size());
  const Index nu = u_.functions, nv = v_.functions, d = dimension_;
  // Rows u first, solved in v: half[(i, j)] = row i of the data in the v basis; column after column of
  // right-hand sides (i, e), so that LAPACK solves them at once, a fixed number at a time.
  std::vector<double> half(lines_u * d * nv, 0.0);
  parallel_chunks(
      lines_u,
      [&](Index, Index begin, Index end) {
        for (Index i = begin; i < end; ++i)
          for (Index j = 0; j < lines_v; ++j)
            for (Index e = 0; e < d; ++e) {
              const double value = x[(i * lines_v + j) * d + e];
              double* out = half.data() + (i * d + e) * nv + v_.first[j];
              const double* b = v_.values.data() + j * v_.width;
              for (int a = 0; a < v_.width; ++a) out[a] += value * b[a];
            }
        v_.matrix.solve(half.data() + begin * d * nv, (end - begin) * d);
      },
      16);
  std::vector<double> right(nv * d * nu, 0.0), net(nu * nv * d);
  parallel_chunks(
      nv,
      [&](Index, Index begin, Index end) {
        for (Index i = 0; i < lines_u; ++i) {
          const double* b = u_.values.data() + i * u_.width;
          for (Index e = 0; e < d; ++e)
            for (Index j = begin; j < end; ++j) {
              const double value = half[(i * d + e) * nv + j];
              double* out = right.data() + (j * d + e) * nu + u_.first[i];
              for (int a = 0; a < u_.width; ++a) out[a] += value * b[a];
            }
        }
        u_.matrix.solve(right.data() + begin * d * nu, (end - begin) * d);
        for (Index j = begin; j < end; ++j)
          for (Index e = 0; e < d; ++e)
            for (Index i = 0; i < nu; ++i) net[(i * nv + j) * d + e] = right[(j * d + e) * nu + i];
      },
      16);
  return net;
}

ResidualSums KroneckerSystem::residuals(const std::vector<double>& net) {
  const Index lines_u = static_cast<Index>(grid_.u.size()), lines_v = static_cast<Index>(grid_.v.size());
  const Index nv = v_.functions, d = dimension_;
  residual_.resize(values_.size());
  std::vector<ResidualSums> sums(lines_u);
  parallel_for(lines_u, [&](Index i) {
    std::vector<double> row(nv * d, 0.0);
    for (int a = 0; a < u_.width; ++a) {
      const double b = u_.values[i * u_.width + a];
      const double* c = net.data() + (u_.first[i] + a) * nv * d;
      for (Index x = 0; x < nv * d; ++x) row[x] += b * c[x];
    }
    for (Index j = 0; j < lines_v; ++j) {
      const double* b = v_.values.data() + j * v_.width;
      double square = 0;
      for (Index e = 0; e < d; ++e) {
        double value = 0;
        for (int a = 0; a < v_.width; ++a) value += b[a] * row[(v_.first[j] + a) * d + e];
        const Index at = (i * lines_v + j) * d + e;
        residual_[at] = value - values_[at];
        square += residual_[at] * residual_[at];
      }
      sums[i] += {square, square, square};
    }
  });
  ResidualSums total;
  for (const ResidualSums& s : sums) total += s;
  total.max = std::sqrt(total.max);
  return total;
}

std::vector<double> KroneckerSystem::errors() const {
  std::vector<double> errors(grid_.point.size());
  for (std::size_t k = 0; k < grid_.point.size(); ++k) {
    double square = 0;
    for (int e = 0; e < dimension_; ++e)
      square += residual_[k * dimension_ + e] * residual_[k * dimension_ + e];
    errors[grid_.point[k]] = std::sqrt(square);
  }
  return errors;
}

double KroneckerSystem::condition() const {
  return u_.matrix.condition(u_.norm) * v_.matrix.condition(v_.norm);
}

}  // namespace knotfit
