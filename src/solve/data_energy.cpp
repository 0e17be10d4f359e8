#include "solve/data_energy.h"

#include <algorithm>
#include <utility>
namespace knotfit {
namespace {

// Cells of at most so many raster cells are added up one by one: differences of sums would lose their digits.
constexpr Index kFewFragments = 16;

/// The cell that holds x, of `side` cells over [0, end].
Index raster_cell(double x, Index side, double end = 1) {
  return std::clamp<Index>(static_cast<Index>(x * (static_cast<double>(side) / end)), 0, side - 1);
}

}  // namespace

DataEnergy::DataEnergy(DataRaster raster) : raster_(std::move(raster)), channels_(kKinds + goal_size()) {
  const Index nu = raster_.side_u, nv = raster_.side_v, nodes = nv + 1, goals = Index{kKinds} * dimension();
  finest_u_.assign(nu, 1.0);
  finest_v_.assign(nv, 1.0);
  for (Index i = 0; i < nu; ++i)
    for (Index j = 0; j < nv; ++j) {
      finest_u_[i] = std::min(finest_u_[i], raster_.spacing_u[i * nv + j]);
      finest_v_[j] = std::min(finest_v_[j], raster_.spacing_v[i * nv + j]);
    }
  // Sums over [0,u] x [0,v] at the raster's nodes.
  sums_.assign((nu + 1) * nodes * channels_, 0.0);
  const double step_u = raster_.end_u / static_cast<double>(nu), step_v = 1 / static_cast<double>(nv);
  for (Index i = 0; i < nu; ++i) {
    const double fu[] = {step_u, step_u * step_u * (static_cast<double>(i) + 0.5)};
    for (Index j = 0; j < nv; ++j) {
      const double fv[] = {step_v, step_v * step_v * (static_cast<double>(j) + 0.5)};
      const Index cell = i * nv + j;
      double* at = sums_.data() + ((i + 1) * nodes + j + 1) * channels_;
      const double *left = at - channels_, *below = at - nodes * channels_, *corner = below - channels_;
      for (int k = 0; k < kKinds; ++k) at[k] = step_u * step_v * raster_.weight[cell * kKinds + k];
      for (Index m = 0; m < kOrder * kOrder; ++m)
        for (Index g = 0; g < goals; ++g)
          at[kKinds + m * goals + g] = fu[m / kOrder] * fv[m % kOrder] * raster_.goal[cell * goals + g];
      for (Index c = 0; c < channels_; ++c) at[c] += left[c] + below[c] - corner[c];
    }
  }
}

void DataEnergy::integrate(double u0, double u1, double v0, double v1, double* weight, double* goal,
                           double* scratch) const {
  const std::array<Index, 4> cells = {raster_cell(u0, raster_.side_u, raster_.end_u),
                                      raster_cell(u1, raster_.side_u, raster_.end_u),
                                      raster_cell(v0, raster_.side_v), raster_cell(v1, raster_.side_v)};
  const std::array<double, 4> box = {u0, u1, v0, v1};
  if ((cells[1] - cells[0] + 1) * (cells[3] - cells[2] + 1) <= kFewFragments)
    add_fragments(cells, box, weight, goal);
  else
    from_sums(box, weight, goal, scratch);
}

void DataEnergy::add_fragments(const std::array<Index, 4>& cells, const std::array<double, 4>& box,
                               double* weight, double* goal) const {
  const Index goals = Index{kKinds} * dimension();
  const auto [u0, u1, v0, v1] = box;
  std::fill_n(weight, kKinds, 0.0);
  std::fill_n(goal, goal_size(), 0.0);
  const double step_u = raster_.end_u / static_cast<double>(raster_.side_u),
               step_v = 1 / static_cast<double>(raster_.side_v);
  // int 1 and int P_1 over the part of the cell's [low, high] in raster column i, in the cell's own length.
  auto part = [](Index i, double step, double low, double high, double* moment) {
    const double a = std::max(low, static_cast<double>(i) * step),
                 b = std::min(high, static_cast<double>(i + 1) * step);
    const double x = std::max(0.0, (a - low) / (high - low)), y = std::min(1.0, (b - low) / (high - low));
    moment[0] = (high - low) * std::max(0.0, y - x);
    moment[1] = moment[0] * (x + y - 1);  // P_1 = 2 x - 1
  };
  for (Index i = cells[0]; i <= cells[1]; ++i) {
    double mu[2], mv[2];
    part(i, step_u, u0, u1, mu);
    for (Index j = cells[2]; j <= cells[3]; ++j) {
      part(j, step_v, v0, v1, mv);
      const Index cell = i * raster_.side_v + j;
      for (int k = 0; k < kKinds; ++k) weight[k] += mu[0] * mv[0] * raster_.weight[cell * kKinds + k];
      for (int a = 0; a < kOrder; ++a)
        for (int b = 0; b < kOrder; ++b)
          for (Index g = 0; g < goals; ++g)
            goal[(a * kOrder + b) * goals + g] += mu[a] * mv[b] * raster_.goal[cell * goals + g];
    }
  }
}

void DataEnergy::sums_up_to(double u, double v, double* sums) const {
  const Index i = raster_cell(u, raster_.side_u, raster_.end_u), j = raster_cell(v, raster_.side_v),
              nodes = raster_.side_v + 1;
  // Shares of the cell's own moments of 1 and x up to u: exact for a piecewise constant raster.
  auto shares = [](double x, Index cell, double step, double* share) {
    const double low = static_cast<double>(cell) * step, high = low + step;
    share[0] = (x - low) / step;
    share[1] = (x * x - low * low) / (high * high - low * low);
  };
  double fu[2], fv[2];
  shares(u, i, raster_.end_u / static_cast<double>(raster_.side_u), fu);
  shares(v, j, 1 / static_cast<double>(raster_.side_v), fv);
  const double *p00 = sums_.data() + (i * nodes + j) * channels_, *p01 = p00 + channels_,
               *p10 = p00 + nodes * channels_, *p11 = p10 + channels_;
  auto blend = [&](Index begin, Index count, double x, double y) {
    const double w00 = (1 - x) * (1 - y), w01 = (1 - x) * y, w10 = x * (1 - y), w11 = x * y;
    for (Index c = begin; c < begin + count; ++c)
      sums[c] = w00 * p00[c] + w01 * p01[c] + w10 * p10[c] + w11 * p11[c];
  };
  const Index goals = Index{kKinds} * dimension();
  blend(0, kKinds, fu[0], fv[0]);
  for (Index a = 0; a < kOrder; ++a)
    for (Index b = 0; b < kOrder; ++b) blend(kKinds + (a * kOrder + b) * goals, goals, fu[a], fv[b]);
}

void DataEnergy::from_sums(const std::array<double, 4>& box, double* weight, double* goal,
                           double* total) const {
  const auto [u0, u1, v0, v1] = box;
  const Index goals = Index{kKinds} * dimension();
  double* corner = total + channels_;
  sums_up_to(u1, v1, total);
  const std::array<std::array<double, 3>, 3> others = {{{u0, v0, 1}, {u0, v1, -1}, {u1, v0, -1}}};
  for (const auto& [u, v, sign] : others) {
    sums_up_to(u, v, corner);
    for (Index c = 0; c < channels_; ++c) total[c] += sign * corner[c];
  }
  for (int k = 0; k < kKinds; ++k) weight[k] = std::max(0.0, total[k]);
  // Moments of 1, v, u, uv become those of P_0 and P_1 of the cell: P_1 = (2 x - low - high) / (high - low).
  const double *m00 = total + kKinds, *m01 = m00 + goals, *m10 = m01 + goals, *m11 = m10 + goals;
  const double au = 2 / (u1 - u0), bu = -(u0 + u1) / (u1 - u0), av = 2 / (v1 - v0),
               bv = -(v0 + v1) / (v1 - v0);
  for (Index g = 0; g < goals; ++g) {
    goal[g] = m00[g];
    goal[goals + g] = av * m01[g] + bv * m00[g];
    goal[2 * goals + g] = au * m10[g] + bu * m00[g];
    goal[3 * goals + g] = au * av * m11[g] + au * bv * m10[g] + bu * av * m01[g] + bu * bv * m00[g];
  }
}

double DataEnergy::finest_spacing(double low, double high, bool along_v) const {
  const std::vector<double>& finest = along_v ? finest_v_ : finest_u_;
  const Index side = along_v ? raster_.side_v : raster_.side_u;
  const double end = along_v ? 1 : raster_.end_u;
  return *std::min_element(finest.begin() + raster_cell(low, side, end),
                           finest.begin() + raster_cell(high, side, end) + 1);
}

}  // namespace knotfit
