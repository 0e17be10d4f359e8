#include "correct/rounds.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "correct/map_hold.h"
#include "correct/parameter_guard.h"
namespace knotfit::correction {
namespace {

// Shares of the tangential distance, and how a round's success changes them.
constexpr double kFirstTangential = 0.3, kLeastTangential = 1e-2, kShrink = 0.6, kGrow = 4;
constexpr int kBatch = 6;            // rounds between halvings of long edges
constexpr double kLongest = 0.6;     // of an edge, in spans
constexpr double kFoldPenalty = 20;  // merit = RMS (1 + 20 folded)
constexpr double kMostHinge = 1e4, kHingeGrow = 3, kHingeDecay = 0.7;

/// RMS and maximum over the data.
struct Errors {
  double square = 0, weight = 0, max = 0;
  Errors& operator+=(const Errors& o) {
    square += o.square, weight += o.weight, max = std::max(max, o.max);
    return *this;
  }
  double rms() const { return weight > 0 ? std::sqrt(square / weight) : 0; }
};

/// A surface judged: distances after one free foot point step, and folds.
struct Verdict {
  Errors errors;
  double folded = 0, merit = INFINITY;
  std::vector<double> squared;  ///< distances, by point
};

/// Rounds on one state of the holding mesh.
class Batch {
 public:
  Batch(HoldingMesh& mesh, const TangentSystem& system, const SpanTable& u, const SpanTable& v,
        const CorrectionOptions& options, double aspect)
      : mesh_(mesh),
        system_(system),
        u_(u),
        v_(v),
        options_(options),
        aspect_(aspect),
        guard_(mesh.face, mesh.size()),
        slides_(slides(mesh, options.slide, options.round_corners)),
        points_(point_weights(mesh)) {
    const std::size_t n = points_.vertex.size();
    for (std::size_t i = 0; i < n; ++i) {
      position_.push_back(mesh.position[points_.vertex[i]]);
      slide_.push_back(slides_[points_.vertex[i]]);
    }
    steps_.longest_u = u.mean_length();
    steps_.longest_v = v.mean_length();
    base_ = points_.weight;
    gather();
    free_ = uv_;
  }

  void begin_round() {
    weigh_added(mesh_, options_.holding, points_);
    reference_ = reference(mesh_, u_, v_, aspect_);
  }
  std::optional<Surface> plain_fit() const {
    return system_.solve({uv_, position_, points_.weight, {}}, options_.smoothing,
                         gradient_data(mesh_, u_, v_, options_.gradient), {});
  }

  /// Moves the parameters to guarded foot points. \return vertices held
  Index move(const CellPolynomials& surface) {
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

  std::optional<Surface> step(const CellPolynomials& surface, double tangential, const HingeState& hinge,
                              double reweighting, const std::vector<double>& squared) {
    std::vector<double> weights = points_.weight;
    if (reweighting > 0) reweigh(reweighting, squared, weights);
    std::vector<Sym3> matrices;
    if (options_.step == CorrectionStep::tangent) {
      matrices.resize(points_.vertex.size());
      const std::vector<std::int32_t> order = order_by_cell(surface, uv_);
      parallel_chunks(
          static_cast<Index>(order.size()),
          [&](Index, Index begin, Index end) {
            for (Index k = begin; k < end; ++k) {
              const std::int32_t i = order[k];
              matrices[i] =
                  matrix(surface.jet(uv_[2 * i], uv_[2 * i + 1]), tangential, slide_[i], &uv_[2 * i]);
            }
          },
          1024);
    }
    return system_.solve({uv_, position_, weights, matrices}, options_.smoothing,
                         gradient_data(mesh_, u_, v_, options_.gradient), hinge.rows);
  }

  Verdict judge(const CellPolynomials& surface) const {
    Verdict verdict;
    std::vector<double> look = free_;
    FootPointOptions once = steps_;
    once.iterations = 1;
    verdict.squared = foot_points(surface, position_, slide_, once, look);
    verdict.errors = parallel_sum<Errors>(static_cast<Index>(position_.size()), [&](Index begin, Index end) {
      Errors e;
      for (Index i = begin; i < end; ++i)
        if (points_.data[i]) e += {base_[i] * verdict.squared[i], base_[i], verdict.squared[i]};
      return e;
    });
    verdict.folded = hinge_rows(surface, reference_, {}).folded;
    verdict.merit = verdict.errors.rms() * (1 + kFoldPenalty * verdict.folded);
    return verdict;
  }

  HingeState hinge(const CellPolynomials& surface, std::vector<double>& weights, bool renew) const {
    if (!options_.hinge || options_.step != CorrectionStep::tangent) return {};
    if (renew) {  // cells that fold weigh more from now on
      const HingeState state = hinge_rows(surface, reference_, weights);
      HingeState rows = state;
      for (std::size_t c = 0; c < weights.size(); ++c)
        weights[c] = state.cell_folds[c] ? std::min(kMostHinge, weights[c] * kHingeGrow)
                                         : std::max(1.0, weights[c] * kHingeDecay);
      return rows;
    }
    return hinge_rows(surface, reference_, weights);
  }

  void set_parameters(std::vector<double> uv) {
    mesh_.uv = std::move(uv);
    gather();
    free_ = uv_;
  }

 private:
  void gather() {
    uv_.resize(2 * points_.vertex.size());
    for (std::size_t i = 0; i < points_.vertex.size(); ++i)
      std::copy_n(&mesh_.uv[2 * points_.vertex[i]], 2, &uv_[2 * i]);
  }

  /// The points' own error metric [Wang06]: M = tau I + (1 - tau) n n^T inside, the side's direction spared on it.
  static Sym3 matrix(const Jet& j, double tangential, Slide slide, const double* uv) {
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

  /// w (1 + kappa min(d / RMS, 8)^2) for the data, their sum kept.
  void reweigh(double kappa, const std::vector<double>& squared, std::vector<double>& weights) const {
    double sum = 0, square = 0, raised = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (points_.data[i]) sum += base_[i], square += base_[i] * squared[i];
    const double mean = square / sum;
    if (!(mean > 0)) return;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (points_.data[i]) raised += weights[i] *= 1 + kappa * std::min(squared[i] / mean, 64.0);
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (points_.data[i]) weights[i] *= sum / raised;
  }

  HoldingMesh& mesh_;
  const TangentSystem& system_;
  const SpanTable &u_, &v_;
  const CorrectionOptions& options_;
  double aspect_;
  ParameterGuard guard_;
  std::vector<Slide> slides_;  ///< by vertex
  PointWeights points_;
  std::vector<double> base_;  ///< 1 / n for the data, else 0
  std::vector<Vec3> position_;
  std::vector<Slide> slide_;
  std::vector<double> uv_;
  std::vector<double> free_;  ///< foot points that no guard holds: the distances are measured there
  FootPointOptions steps_;
  Reference reference_;
};

Surface between(const Surface& from, const Surface& to, double share) {
  std::vector<double> net = from.net();
  for (std::size_t k = 0; k < net.size(); ++k) net[k] += share * (to.net()[k] - net[k]);
  return Surface(from.knots_u(), from.knots_v(), 3, std::move(net));
}

}  // namespace

Rounds run_rounds(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                  const CorrectionOptions& options, const Watch& watch) {
  const SpanTable u(knots_u), v(knots_v);
  const TangentSystem system(knots_u, knots_v, options.aspect);
  Rounds result;
  std::vector<double> hinge_weights(static_cast<std::size_t>(u.spans() * v.spans()), 1.0);
  std::optional<Surface> last = options.start;
  double best_of_all = INFINITY, first_tangential = kFirstTangential;
  const Index given = mesh.size();
  const auto own = [&](const std::vector<double>& uv) {
    return std::vector<double>(uv.begin(), uv.begin() + 2 * given);
  };
  for (int done = 0; done == 0 || done < options.rounds; done += kBatch) {
    const int rounds = std::min(options.rounds - done, kBatch);
    halve_long_edges(mesh, kLongest * u.mean_length(), kLongest * v.mean_length());
    Batch batch(mesh, system, u, v, options, options.aspect);
    batch.begin_round();
    Surface surface;
    {
      std::optional<Surface> start = last ? last : batch.plain_fit();
      if (!start) return result;
      surface = std::move(*start);
    }
    Verdict verdict = batch.judge(CellPolynomials(surface));
    Surface best = surface;
    std::vector<double> best_uv = mesh.uv;
    double best_merit = verdict.merit, merit = verdict.merit, tangential = first_tangential;
    const auto keep = [&] {
      if (!(verdict.merit < best_of_all)) return;
      best_of_all = verdict.merit;
      result.surface = surface;
      result.uv = own(mesh.uv);
      result.best = static_cast<Index>(result.rounds.size()) - 1;
    };
    if (done == 0) {
      result.rounds.push_back(
          {verdict.errors.rms(), std::sqrt(verdict.errors.max), verdict.folded, 1, 1, 0, 0});
      keep();
    }
    int bad = 0;
    for (int round = 0; round < rounds; ++round) {
      if (watch.report(static_cast<double>(done + round) / options.rounds, result.rounds[result.best].rms)) {
        result.stopped = true;
        return result;
      }
      const CellPolynomials now(surface);
      CorrectionRound record;
      record.tangential = tangential;
      record.held = batch.move(now);
      batch.begin_round();
      const HingeState hinge = batch.hinge(now, hinge_weights, done + round > 0);
      record.hinge_rows = static_cast<Index>(hinge.rows.size());
      const double reweighting = 2 * (done + round) >= options.rounds ? options.reweighting : 0;
      const std::optional<Surface> solved = batch.step(now, tangential, hinge, reweighting, verdict.squared);
      if (!solved) {
        result.rounds.push_back(record);
        break;
      }
      // Shorter steps while the merit rises; the least of them is taken.
      Surface next = *solved;
      verdict = batch.judge(CellPolynomials(next));
      double share = 1;
      for (int shorter = 0; shorter < 3 && verdict.merit > merit; ++shorter) {
        share *= 0.4;
        const Surface trial = between(surface, *solved, share);
        Verdict of_trial = batch.judge(CellPolynomials(trial));
        if (!(of_trial.merit < verdict.merit)) continue;
        verdict = std::move(of_trial);
        next = trial;
        record.step = share;
      }
      surface = std::move(next);
      record.rms = verdict.errors.rms();
      record.max = std::sqrt(verdict.errors.max);
      record.folded = verdict.folded;
      result.rounds.push_back(record);
      keep();
      if (verdict.merit < best_merit) {
        best_merit = verdict.merit;
        best = surface;
        best_uv = mesh.uv;
      }
      if (verdict.merit < merit * 1.0001) {
        tangential = std::max(kLeastTangential, tangential * kShrink);
        bad = 0;
      } else {
        tangential = std::min(1.0, tangential * kGrow);
        if (verdict.merit > 1.5 * best_merit || ++bad > 3) {
          surface = best;
          batch.set_parameters(best_uv);
          verdict.merit = best_merit;
          bad = 0;
        }
      }
      merit = verdict.merit;
    }
    batch.set_parameters(best_uv);
    batch.move(CellPolynomials(best));
    last = best;
    first_tangential = std::max(kLeastTangential, first_tangential * std::pow(kShrink, rounds));
  }
  return result;
}

}  // namespace knotfit::correction
