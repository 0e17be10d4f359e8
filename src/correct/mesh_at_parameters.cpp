#include "correct/mesh_at_parameters.h"

#include <algorithm>

#include "base/parallel.h"
#include "correct/penalised_error.h"
#include "fit/error_measure.h"
namespace knotfit::correction {
namespace {

constexpr double kLongest = 0.6;  // of an edge, in mean spans [METHOD 8.2]
// Vertices a cell [METHOD 8.8]: below the first a mesh shows no curvature, from the second on all of it.
constexpr double kCoarse = 4, kFine = 15;
// Weight of a cell's hinge rows [METHOD 8.7].
constexpr double kMostHinge = 1e4, kHingeGrow = 3, kHingeDecay = 0.7;
constexpr double kMostRaised = 64;  // of squared distances by their mean: 8 times the RMS

struct Errors {
  double square = 0, weight = 0, max = 0;
  Errors& operator+=(const Errors& o) {
    square += o.square, weight += o.weight, max = std::max(max, o.max);
    return *this;
  }
};

/// The metric of a point's error [Wang06]: M = tau I + (1 - tau) n n^T inside the square. On a side, the distance along it
/// counts by tau.
Sym3 matrix(const Jet& j, double tangential, Slide slide, const double* uv) {
  const auto spare = [&](const Vec3& t) {
    const double l = squared(t);
    return l > 0 ? with_axis(1, -(1 - tangential) / l, t) : Sym3{};
  };
  const bool on_u = uv[0] == 0 || uv[0] == 1, on_v = uv[1] == 0 || uv[1] == 1;
  if (slide == Slide::fixed || (slide == Slide::round && on_u && on_v)) return {};
  if (slide == Slide::along_v || (slide == Slide::round && on_u)) return spare(j.v);
  if (slide == Slide::along_u || (slide == Slide::round && on_v)) return spare(j.u);
  const Vec3 n = cross(j.u, j.v);
  const double l = length(n);
  if (!(l > 1e-3 * length(j.u) * length(j.v))) return {};
  return with_axis(tangential, 1 - tangential, (1 / l) * n);
}

HoldingMesh& with_short_edges(HoldingMesh& mesh, const FixedKnots& knots) {
  halve_long_edges(mesh, kLongest * knots.u.mean_length(), kLongest * knots.v.mean_length());
  return mesh;
}

}  // namespace

MeshAtParameters::MeshAtParameters(HoldingMesh& mesh, const FixedKnots& knots,
                                   const CorrectionOptions& options)
    : mesh_(with_short_edges(mesh, knots)),
      knots_(knots),
      options_(options),
      guard_(mesh.face, mesh.size()),
      slides_(slides(mesh, options.slide, options.round_corners)),
      points_(point_weights(mesh)),
      base_(points_.weight) {
  for (const std::int32_t k : points_.vertex) {
    position_.push_back(mesh.position[k]);
    slide_.push_back(slides_[k]);
  }
  const double a_cell =
      static_cast<double>(mesh.own) / static_cast<double>(knots.u.spans() * knots.v.spans());
  resolved_ = std::clamp((a_cell - kCoarse) / (kFine - kCoarse), 0.0, 1.0);
  steps_.longest_u = knots.u.mean_length();
  steps_.longest_v = knots.v.mean_length();
  gather();
  free_ = uv_;
  begin_round();
}

void MeshAtParameters::begin_round() {
  weigh_added(mesh_, options_.holding, points_);
  reference_ = reference(mesh_, knots_.u, knots_.v, options_.aspect);
}

std::optional<Surface> MeshAtParameters::plain_fit() const {
  return knots_.system.solve({uv_, position_, points_.weight, {}}, options_.smoothing,
                             {gradient_data(mesh_, knots_.u, knots_.v, options_.gradient), {}});
}

Index MeshAtParameters::move(const CellPolynomials& surface) {
  const std::vector<double> from = mesh_.uv;
  foot_points(surface, position_, slide_, steps_, uv_);
  foot_points(surface, position_, slide_, steps_, free_);
  for (std::size_t i = 0; i < points_.vertex.size(); ++i)
    std::copy_n(&uv_[2 * i], 2, &mesh_.uv[2 * points_.vertex[i]]);
  const Index held = guard_.hold(from, mesh_.uv);
  if (held > 0) guard_.relax(mesh_.uv, slides_, 2);
  gather();
  return held;
}

std::vector<double> MeshAtParameters::weights(const std::vector<double>& factor) const {
  std::vector<double> result = points_.weight;
  double sum = 0, raised = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (points_.data[i]) sum += base_[i], raised += base_[i] * factor[i];
  if (!(raised > 0)) return result;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (points_.data[i]) result[i] = base_[i] * factor[i] * (sum / raised);
  return result;
}

std::vector<double> MeshAtParameters::weights(double kappa, const std::vector<double>& squared) const {
  if (!(kappa > 0)) return points_.weight;
  double sum = 0, square = 0;
  for (std::size_t i = 0; i < base_.size(); ++i)
    if (points_.data[i]) sum += base_[i], square += base_[i] * squared[i];
  const double mean = square / sum;
  if (!(mean > 0)) return points_.weight;
  std::vector<double> factor(base_.size(), 1.0);
  for (std::size_t i = 0; i < factor.size(); ++i)
    factor[i] += kappa * std::min(squared[i] / mean, kMostRaised);
  return weights(factor);
}

std::vector<Sym3> MeshAtParameters::matrices(const CellPolynomials& surface, double tangential) const {
  std::vector<Sym3> result(points_.vertex.size());
  const std::vector<std::int32_t> order = order_by_cell(surface, uv_);
  parallel_chunks(
      static_cast<Index>(order.size()),
      [&](Index, Index begin, Index end) {
        for (Index k = begin; k < end; ++k) {
          const std::int32_t i = order[k];
          result[i] = matrix(surface.jet(uv_[2 * i], uv_[2 * i + 1]), tangential, slide_[i], &uv_[2 * i]);
        }
      },
      1024);
  return result;
}

std::optional<Surface> MeshAtParameters::step(const CellPolynomials& surface, double tangential,
                                              const HingeState& hinge,
                                              const std::vector<double>& weights) const {
  std::vector<Sym3> m;
  if (options_.step == CorrectionStep::tangent) m = matrices(surface, tangential);
  return knots_.system.solve(
      {uv_, position_, weights, m}, options_.smoothing,
      {gradient_data(mesh_, knots_.u, knots_.v, options_.gradient), hinge.rows, hinge.curvature});
}

std::optional<KnotJacobian> MeshAtParameters::knot_jacobian(const Surface& surface, double tangential,
                                                            const HingeState& hinge,
                                                            const std::vector<double>& weights) const {
  const std::vector<Sym3> m = matrices(CellPolynomials(surface), tangential);
  return knots_.system.knot_jacobian(
      {uv_, position_, weights, m}, options_.smoothing,
      {gradient_data(mesh_, knots_.u, knots_.v, options_.gradient), hinge.rows, hinge.curvature}, surface,
      points_.data);
}

Judgement MeshAtParameters::judge(const CellPolynomials& surface) const {
  Judgement judgement;
  std::vector<double> look = free_;
  FootPointOptions once = steps_;
  once.iterations = 1;
  judgement.squared = foot_points(surface, position_, slide_, once, look);
  const Errors errors =
      parallel_sum<Errors>(static_cast<Index>(position_.size()), [&](Index begin, Index end) {
        Errors e;
        for (Index i = begin; i < end; ++i)
          if (points_.data[i]) e += {base_[i] * judgement.squared[i], base_[i], judgement.squared[i]};
        return e;
      });
  judgement.rms = errors.weight > 0 ? std::sqrt(errors.square / errors.weight) : 0;
  judgement.max = std::sqrt(errors.max);
  const ErrorMeasureRow& row = row_of(options_.keep_by.measure);
  if (row.of_sums) {
    judgement.error = row.of_sums(judgement.rms, judgement.max);
  } else {
    std::vector<double> distances;
    for (std::size_t i = 0; i < base_.size(); ++i)
      if (points_.data[i]) distances.push_back(std::sqrt(judgement.squared[i]));
    judgement.error = measured_error(distances, options_.keep_by);
  }
  judgement.folded = hinge_rows(surface, reference_, {}).folded;
  judgement.penalised_error = penalised_error(judgement.rms, judgement.folded);
  return judgement;
}

HingeState MeshAtParameters::hinge(const CellPolynomials& surface, std::vector<double>& weights, bool renew,
                                   double fairness) const {
  if (options_.step != CorrectionStep::tangent || (!options_.hinge && options_.fairness == 0)) return {};
  HingeState state = hinge_rows(surface, reference_, weights, fairness * resolved_ * options_.fairness);
  if (!options_.hinge) state.rows.clear();
  if (renew)
    for (std::size_t c = 0; c < weights.size(); ++c)
      weights[c] = state.cell_folds[c] ? std::min(kMostHinge, weights[c] * kHingeGrow)
                                       : std::max(1.0, weights[c] * kHingeDecay);
  return state;
}

void MeshAtParameters::set_parameters(std::vector<double> uv) {
  mesh_.uv = std::move(uv);
  gather();
  free_ = uv_;
}

void MeshAtParameters::gather() {
  uv_.resize(2 * points_.vertex.size());
  for (std::size_t i = 0; i < points_.vertex.size(); ++i)
    std::copy_n(&mesh_.uv[2 * points_.vertex[i]], 2, &uv_[2 * i]);
}

Surface between(const Surface& from, const Surface& to, double share) {
  std::vector<double> net = from.net();
  for (std::size_t k = 0; k < net.size(); ++k) net[k] += share * (to.net()[k] - net[k]);
  return Surface(from.knots_u(), from.knots_v(), 3, std::move(net));
}

}  // namespace knotfit::correction
