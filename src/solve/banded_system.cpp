#include "solve/banded_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "solve/cell_energy.h"
#include "solve/degrees.h"
#include "solve/gram_entries.h"
#include "solve/point_kernels.h"
#include "solve/spans_in_turn.h"
#include "solve/thin_plate.h"
namespace knotfit {
namespace {

template <int rows, int columns>
using ConstMap =
    Eigen::Map<const Eigen::Matrix<double, rows, columns,
                                   (rows != 1 && columns == 1) ? Eigen::ColMajor : Eigen::RowMajor>>;
template <int rows, int columns>
using Matrix = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;
static_assert(kDynamic == Eigen::Dynamic);

}  // namespace

BandedSystem::BandedSystem(const ParameterizedPoints& points, std::shared_ptr<const DataEnergy> energy)
    : order_(points), energy_(std::move(energy)), counted_(points.size()) {}

double BandedSystem::mean_weight() const {
  if (order_.weights().empty()) return 1;
  const std::vector<double>& w = order_.weights();
  return parallel_sum<double>(order_.size(),
                              [&](Index begin, Index end) {
                                return std::accumulate(w.begin() + begin, w.begin() + end, 0.0);
                              }) /
         static_cast<double>(order_.size());
}

void BandedSystem::arrange(const Axis& u, const Axis& v) {
  swapped_ = v.functions() > u.functions();
  outer_ = swapped_ ? &v : &u;
  inner_ = swapped_ ? &u : &v;
  if (u.knots() == arranged_u_ && v.knots() == arranged_v_) return;
  order_.sort(*outer_, *inner_, swapped_);
  arranged_u_ = u.knots();
  arranged_v_ = v.knots();
}

bool BandedSystem::factor(const Axis& u, const Axis& v, double relative_smoothing) {
  arrange(u, v);
  const Axis &outer = *outer_, &inner = *inner_;
  empty_cells_ = order_.empty_cells();

  const int d = order_.dimension(), stride = padded(inner.moments());
  const Index matrix_size = Index{outer.moments()} * stride,
              rhs_size = Index{d} * outer.width() * inner.width();
  const auto& pieces = order_.pieces();
  const auto& start = order_.piece_start();
  moments_a_piece_ = matrix_size + rhs_size;
  moments_.assign(pieces.size() * (matrix_size + rhs_size), 0.0);
  parallel_for(static_cast<Index>(pieces.size()), [&](Index i) {
    double* m = moments_.data() + i * (matrix_size + rhs_size);
    add_moments(order_, pieces[i], outer.degree(), inner.degree(), m, m + matrix_size);
  });

  const Index ni = inner.functions();
  matrix_.reset(outer.functions() * ni, outer.degree() * ni + inner.degree());
  data_rhs_.assign(outer.functions() * ni * d, 0.0);
  for_degrees(outer.degree(), inner.degree(), [&]<int degree>() {
    constexpr int w = width_of(degree), q = moments_of(degree), np = pairs_of(degree);
    const int wo = outer.width(), wi = inner.width();
    for_spans_in_turn(outer, [&](Index s) {
      const ConstMap<np, q> po(outer.products(s), outer.pairs(), outer.moments());
      const ConstMap<w, w> bo(outer.basis(s), wo, wo);
      Matrix<np, np> gram(outer.pairs(), inner.pairs());
      Matrix<np, q> half(outer.pairs(), inner.moments());
      Matrix<w, w> rhs(wo, wi);
      for (Index r = 0; r < inner.spans(); ++r) {
        const Index cell = s * inner.spans() + r, first = start[cell], count = start[cell + 1] - first;
        if (count == 0) continue;
        double* m = moments_.data() + first * (matrix_size + rhs_size);
        for (Index step = 1; step < count; step *= 2)  // long cells: partials added as a tree
          for (Index i = 0; i + step < count; i += 2 * step)
            for (Index x = 0; x < matrix_size + rhs_size; ++x)
              m[i * (matrix_size + rhs_size) + x] += m[(i + step) * (matrix_size + rhs_size) + x];
        const Eigen::Map<const Matrix<q, q>, 0, Eigen::OuterStride<>> mom(m, outer.moments(), inner.moments(),
                                                                          Eigen::OuterStride<>(stride));
        const ConstMap<np, q> pi(inner.products(r), inner.pairs(), inner.moments());
        half.noalias() = po.lazyProduct(mom);
        gram.noalias() = half.lazyProduct(pi.transpose());
        each_gram_entry({s, r, wo, wi, ni},
                        [&](Index x, Index y, int row, int column) { matrix_.add(x, y, gram(row, column)); });
        const ConstMap<w, w> bi(inner.basis(r), wi, wi);
        for (int e = 0; e < d; ++e) {
          const ConstMap<w, w> x(m + matrix_size + e * wo * wi, wo, wi);
          rhs.noalias() = bo.transpose() * x * bi;
          for (int i = 0; i < wo; ++i)
            for (int j = 0; j < wi; ++j) data_rhs_[((s + i) * ni + r + j) * d + e] += rhs(i, j);
        }
      }
    });
  });
  add_smoothing(relative_smoothing);
  if (energy_) add_energy(*energy_, {outer, inner, swapped_}, mean_weight(), matrix_, data_rhs_);
  if (keep_norm_) norm_ = matrix_.norm_1();
  return matrix_.factor();
}

void BandedSystem::add_smoothing(double relative) {
  const EnergyGrams o(*outer_), i(*inner_);
  const double trace_energy = energy_trace(o, i);
  smoothing_ = trace_energy > 0 ? relative * matrix_.trace() / trace_energy : 0;
  if (smoothing_ == 0) return;
  each_energy_entry(
      o, i, [&](Index row, Index column, double entry) { matrix_.add(row, column, smoothing_ * entry); });
}

std::vector<double> BandedSystem::project(bool residual) {
  const Axis &outer = *outer_, &inner = *inner_;
  const int d = order_.dimension(), wo = outer.width(), wi = inner.width();
  const Index no = outer.functions(), ni = inner.functions(), n = no * ni;
  std::vector<double> rhs;
  if (!residual) {
    rhs = data_rhs_;
  } else {
    const Index size = Index{d} * wo * wi;
    const auto& pieces = order_.pieces();
    const auto& start = order_.piece_start();
    std::vector<double> sums(pieces.size() * size, 0.0);
    parallel_for(static_cast<Index>(pieces.size()), [&](Index i) {
      add_rhs_moments(order_, pieces[i], outer.degree(), inner.degree(), residual_.data(),
                      sums.data() + i * size);
    });
    rhs.assign(n * d, 0.0);
    for_degrees(outer.degree(), inner.degree(), [&]<int degree>() {
      constexpr int w = width_of(degree);
      for_spans_in_turn(outer, [&](Index s) {
        const ConstMap<w, w> bo(outer.basis(s), wo, wo);
        Matrix<w, w> y(wo, wi);
        for (Index r = 0; r < inner.spans(); ++r) {
          const ConstMap<w, w> bi(inner.basis(r), wi, wi);
          const Index cell = s * inner.spans() + r;
          for (Index p = start[cell]; p < start[cell + 1]; ++p)
            for (int e = 0; e < d; ++e) {
              const ConstMap<w, w> x(sums.data() + p * size + e * wo * wi, wo, wi);
              y.noalias() = bo.transpose() * x * bi;
              for (int i = 0; i < wo; ++i)
                for (int j = 0; j < wi; ++j) rhs[((s + i) * ni + r + j) * d + e] += y(i, j);
            }
        }
      });
    });
  }
  if (residual && energy_) add_energy_gradient(*energy_, {outer, inner, swapped_}, mean_weight(), net_, rhs);
  std::vector<double> x(n * d);
  for (Index k = 0; k < n; ++k)
    for (int e = 0; e < d; ++e) x[e * n + k] = rhs[k * d + e];
  matrix_.solve(x.data(), d);
  std::vector<double> net(n * d);
  for (Index a = 0; a < no; ++a)
    for (Index b = 0; b < ni; ++b)
      for (int e = 0; e < d; ++e) net[(swapped_ ? b * no + a : a * ni + b) * d + e] = x[e * n + a * ni + b];
  return net;
}

ResidualSums BandedSystem::residuals(const std::vector<double>& net) {
  const Axis &outer = *outer_, &inner = *inner_;
  const int d = order_.dimension(), wo = outer.width(), wi = inner.width();
  const Index no = outer.functions(), ni = inner.functions();
  if (energy_) net_ = net;
  residual_.resize(order_.size() * d);
  const auto& pieces = order_.pieces();
  const auto& start = order_.piece_start();
  std::vector<ResidualSums> sums(pieces.size());
  for_degrees(outer.degree(), inner.degree(), [&]<int degree>() {
    constexpr int w = width_of(degree);
    parallel_for(outer.spans(), [&](Index s) {
      const ConstMap<w, w> bo(outer.basis(s), wo, wo);
      Matrix<w, w> c(wo, wi);
      std::vector<double> local(d * wo * wi);
      for (Index r = 0; r < inner.spans(); ++r) {
        const Index cell = s * inner.spans() + r;
        if (start[cell] == start[cell + 1]) continue;
        const ConstMap<w, w> bi(inner.basis(r), wi, wi);
        for (int e = 0; e < d; ++e) {
          for (int i = 0; i < wo; ++i)
            for (int j = 0; j < wi; ++j)
              c(i, j) = net[(swapped_ ? (r + j) * no + s + i : (s + i) * ni + r + j) * d + e];
          Eigen::Map<Matrix<w, w>>(local.data() + e * wo * wi, wo, wi).noalias() = bo * c * bi.transpose();
        }
        for (Index p = start[cell]; p < start[cell + 1]; ++p)
          sums[p] = set_residuals(order_, pieces[p], outer.degree(), inner.degree(), counted_, local.data(),
                                  residual_.data());
      }
    });
  });
  ResidualSums total;
  for (const ResidualSums& s : sums) total += s;
  total.max = std::sqrt(total.max);
  return total;
}

ResidualSums BandedSystem::set_residual(std::vector<double> residual) {
  residual_ = std::move(residual);
  ResidualSums total = parallel_sum<ResidualSums>(order_.size(), [&](Index begin, Index end) {
    ResidualSums sum;
    for (Index i = begin; i < end; ++i) sum += sums_of(i);
    return sum;
  });
  total.max = std::sqrt(total.max);
  return total;
}

ResidualSums BandedSystem::sums_of(Index stored) const {
  const double square = squared(stored);
  const double weight = order_.weights().empty() ? 1.0 : order_.weights()[stored];
  const bool counts = order_.input(stored) < counted_;
  return {counts ? square : 0, weight * square, counts ? square : 0};
}

double BandedSystem::squared(Index stored) const {
  const int d = order_.dimension();
  double square = 0;
  for (int e = 0; e < d; ++e) square += residual_[stored * d + e] * residual_[stored * d + e];
  return square;
}

std::vector<double> BandedSystem::errors() const {
  std::vector<double> errors(order_.size());
  parallel_chunks(order_.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) errors[order_.input(i)] = std::sqrt(squared(i));
  });
  return errors;
}

}  // namespace knotfit
