#include "knotfit/fit_sheared.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/deadline.h"
#include "data/thinned.h"
#include "fit/fit_problem.h"
#include "knotfit/exceptions.h"
#include "pipeline/request.h"
namespace knotfit {
namespace {

constexpr Index kPoints = 10000;
constexpr int kKnots = 12;
constexpr double kStep = 0.1, kFinestStep = 0.02;
constexpr double kGain = 0.9;  // of the RMS without it; a shear that gains less is not worth its corners

void check_height_field(const ParameterizedPoints& points) {
  if (!points.height_field || points.dimension != 1)
    throw InvalidInput("a shear is for height fields: the data's own parameters have no x and y to shear");
  if (points.map.sheared()) throw InvalidInput("the points are sheared already");
}

/// RMS error of the error model's knots at a shear.
class ShearError {
 public:
  ShearError(const ParameterizedPoints& points, const FitOptions& options) : smoothing_(options.smoothing) {
    points_ = thinned(Frame(points).inside(points), kPoints);
    placement_.degree_u = options.degree_u;
    placement_.degree_v = options.degree_v;
    placement_.smoothing = options.smoothing;
    const int few = static_cast<int>(std::sqrt(static_cast<double>(points_.size())) / 4);
    placement_.interior_u = placement_.interior_v = std::clamp(few, 1, kKnots);
  }
  double operator()(Shear shear) const {
    const ParameterizedPoints points = sheared(points_, shear.u, shear.v);
    LeastSquaresOptions fit;
    fit.smoothing = smoothing_;
    fit.estimate_condition = false;
    FitProblem problem(points, placement_.degree_u, placement_.degree_v, fit);
    return problem.solve(place_knots("error-model", points, placement_).knots)
               ? problem.rms()
               : std::numeric_limits<double>::infinity();
  }

 private:
  double smoothing_;
  ParameterizedPoints points_;
  PlacementOptions placement_;
};

Index size_of(const FitResult& r) {
  return r.surface.control_point_count();
}

bool better(const FitResult& a, const FitResult& b, bool fixed) {
  if (a.surface.empty() || b.surface.empty()) return !a.surface.empty();
  if (fixed) return a.error.rms < b.error.rms;
  if (a.reached != b.reached) return a.reached;
  if (a.reached) return size_of(a) < size_of(b);
  return a.swings.swings != b.swings.swings ? !a.swings.swings : a.measured < b.measured;
}

std::string formula(Shear s) {
  const bool in_u = s.u != 0;
  const double a = in_u ? s.u : s.v;
  return fmt::format("{} {} {:.3g} {}", in_u ? "u" : "v", a < 0 ? "-" : "+", std::abs(a), in_u ? "v" : "u");
}

std::string outcome(const FitResult& r, bool fixed) {
  if (r.surface.empty()) return "no surface";
  if (fixed) return fmt::format("RMS error {:.4g}", r.error.rms);
  return fmt::format("{} control points{}", size_of(r), r.reached ? "" : ", tolerance not reached");
}

}  // namespace

Shear find_shear(const ParameterizedPoints& points, const FitOptions& options, const Control& control) {
  check_height_field(points);
  const ShearError error(points, options);
  const double plain = error({});
  Shear best;
  double least = plain;
  auto attempt = [&](Shear shear) {
    if (control.stop.stop_requested() || std::max(std::abs(shear.u), std::abs(shear.v)) > 1) return;
    if (const double e = error(shear); e < least) {
      least = e;
      best = shear;
    }
  };
  for (int i = -10; i <= 10; ++i) {
    if (i == 0) continue;
    if (control.progress) {
      Progress progress;
      progress.stage = "shear";
      progress.fraction = (i + 10) / 20.0;
      control.progress(progress);
    }
    attempt({i * kStep, 0});
    attempt({0, i * kStep});
  }
  if (best.u == 0 && best.v == 0) return {};
  for (double step = kStep / 2; step > kFinestStep; step /= 2) {
    const Shear middle = best;
    for (double sign : {-1.0, 1.0})
      attempt(middle.u != 0 ? Shear{middle.u + sign * step, 0} : Shear{0, middle.v + sign * step});
  }
  return least < kGain * plain ? best : Shear{};
}

ShearedFit fit_sheared(const ParameterizedPoints& points, const FitOptions& options,
                       std::optional<Shear> shear, const Control& control) {
  check_height_field(points);
  const Deadline deadline(control);
  const bool given = shear.has_value();
  if (!given) shear = find_shear(points, options, control);
  ShearedFit plain{fit_surface(points, options, deadline.left()), points};
  if (shear->u == 0 && shear->v == 0) {
    if (!given)
      plain.result.notes.push_back(
          "no oblique parameters tried: none lowers the error of the error model's knots by a tenth");
    return plain;
  }
  ShearedFit oblique{{}, sheared(points, shear->u, shear->v)};
  oblique.result = fit_surface(oblique.points, options, deadline.left());
  const bool fixed = has_size_or_knots(options);
  const bool wins = better(oblique.result, plain.result, fixed);
  const std::string of_oblique = outcome(oblique.result, fixed), of_plain = outcome(plain.result, fixed);
  if (wins) {
    oblique.result.fits += plain.result.fits;
    oblique.result.notes.push_back(
        fmt::format("oblique parameters, {} in place of {}: {} against {} without; the surface's corners "
                    "beyond the data hold no promise",
                    formula(*shear), shear->u != 0 ? "u" : "v", of_oblique, of_plain));
    return oblique;
  }
  plain.result.fits += oblique.result.fits;
  plain.result.notes.push_back(fmt::format("oblique parameters ({}) tried and left: {} against {} without",
                                           formula(*shear), of_oblique, of_plain));
  return plain;
}

}  // namespace knotfit
