// A surface as faces that CAD systems digest.
#include "knotfit/cad_safe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "knotfit/exceptions.h"
#include "spline/clamped.h"
#include "spline/elevation.h"
#include "spline/projection.h"
#include "spline/splitting.h"
namespace knotfit {
namespace {

constexpr Index kMostReduced = 4000;  ///< control points a direction while a lower degree is tried

/// What the surface may still move by; an operation takes an equal share of what those before it left.
class Budget {
 public:
  Budget(double tolerance, double rounding, int operations)
      : left_(tolerance), rounding_(rounding), operations_(operations) {}
  double share() const { return std::max(left_ / operations_, rounding_); }
  bool open() const { return left_ > 0; }
  void spend(double error) {
    left_ = std::max(0.0, left_ - error);
    --operations_;
  }

 private:
  double left_, rounding_;
  int operations_;
};

/// Distinct knots with their multiplicities.
struct Break {
  double at = 0;
  int multiplicity = 0;
};

std::vector<Break> breaks_of(const KnotVector& knots) {
  std::vector<Break> result;
  for (const double at : knots.breaks()) result.push_back({at, knots.multiplicity(at)});
  return result;
}

KnotVector knots_of(int degree, const std::vector<Break>& breaks) {
  std::vector<double> interior;
  for (std::size_t b = 1; b + 1 < breaks.size(); ++b)
    interior.insert(interior.end(), static_cast<std::size_t>(breaks[b].multiplicity), breaks[b].at);
  return KnotVector::clamped(degree, interior, breaks.front().at, breaks.back().at);
}

/// Breaks [begin, end) that are to be one: the first run closer than `gap`, or none.
std::optional<std::pair<std::size_t, std::size_t>> near_run(const std::vector<Break>& breaks, double gap) {
  for (std::size_t b = 1; b < breaks.size(); ++b) {
    if (breaks[b].at - breaks[b - 1].at >= gap) continue;
    std::size_t end = b + 1;
    while (end < breaks.size() && breaks[end].at - breaks[b - 1].at < gap) ++end;
    return std::pair{b - 1, end};
  }
  return std::nullopt;
}

/// Where a run's one knot goes: an end of the domain, else the middle of those of the highest multiplicity, so
/// that a fold stays in its place.
double place_of(const std::vector<Break>& breaks, std::size_t begin, std::size_t end) {
  if (begin == 0) return breaks.front().at;
  if (end == breaks.size()) return breaks.back().at;
  int highest = 0;
  for (std::size_t b = begin; b < end; ++b) highest = std::max(highest, breaks[b].multiplicity);
  double offset = 0;
  int count = 0;
  for (std::size_t b = begin; b < end; ++b)
    if (breaks[b].multiplicity == highest) {
      offset += breaks[b].at - breaks[begin].at;
      ++count;
    }
  return breaks[begin].at + offset / count;
}

/// Knots nearer than `gap` along u become one, with the lowest multiplicity that holds the budget's share.
Surface merged_u(Surface s, double least_distance, Budget& budget, char name) {
  const double gap = least_distance * (s.knots_u().last() - s.knots_u().first());
  const double allowed = budget.share();
  double spent = 0;
  std::vector<Break> breaks = breaks_of(s.knots_u());
  while (const auto run = near_run(breaks, gap)) {
    const auto [begin, end] = *run;
    if (begin == 0 && end == breaks.size())
      throw InvalidInput(fmt::format("all knots along {} lie nearer than the least distance", name));
    int lowest = 0, sum = 0;
    for (std::size_t b = begin; b < end; ++b) {
      lowest = std::max(lowest, breaks[b].multiplicity);
      sum += breaks[b].multiplicity;
    }
    const bool at_end = begin == 0 || end == breaks.size();
    const int highest = at_end ? lowest : std::max(lowest, std::min(sum, s.degree_u()));
    Break one{place_of(breaks, begin, end), lowest};
    double error = std::numeric_limits<double>::infinity();
    for (; one.multiplicity <= highest; ++one.multiplicity) {
      std::vector<Break> fewer = breaks;
      fewer.erase(fewer.begin() + begin, fewer.begin() + end);
      fewer.insert(fewer.begin() + begin, one);
      Projection merged = project_u(s, knots_of(s.degree_u(), fewer));
      error = std::min(error, merged.error);
      if (!(spent + merged.error <= allowed)) continue;
      spent += merged.error;
      s = std::move(merged.surface);
      breaks = std::move(fewer);
      break;
    }
    if (one.multiplicity > highest)
      throw InvalidInput(
          fmt::format("the knots {} and {} along {} are nearer than {:.3g} of the domain, and merging them "
                      "may move the surface "
                      "by {:.3g}, where {:.3g} is allowed; allow more, or a smaller distance of knots",
                      breaks[begin].at, breaks[end - 1].at, name, least_distance, error, allowed));
  }
  budget.spend(spent);
  return s;
}

/// The least knots of `degree` with the continuity of these.
std::vector<Break> reduced_breaks(const KnotVector& knots, int degree) {
  std::vector<Break> breaks = breaks_of(knots);
  for (Break& b : breaks) b.multiplicity = std::max(1, degree - (knots.degree() - b.multiplicity));
  return breaks;
}

/// Least squares over the same knots; spans that miss the budget's share are halved.
Surface reduced_u(const Surface& s, int degree, double least_distance, Budget& budget, char name) {
  const double allowed = budget.share(), domain = s.knots_u().last() - s.knots_u().first();
  std::vector<Break> breaks = reduced_breaks(s.knots_u(), degree);
  for (;;) {
    const KnotVector knots = knots_of(degree, breaks);
    Projection reduced = project_u(s, knots);
    if (reduced.error <= allowed) {
      budget.spend(reduced.error);
      return std::move(reduced.surface);
    }
    std::vector<Break> finer = {breaks.front()};
    bool room = budget.open() && knots.size() < kMostReduced;
    for (std::size_t b = 1; b < breaks.size(); ++b) {
      const double width = breaks[b].at - breaks[b - 1].at;
      if (!(reduced.span_errors[b - 1] <= allowed)) {
        room = room && width > 4 * std::max(least_distance, 1e-12) * domain;
        finer.push_back({breaks[b - 1].at + width / 2, 1});
      }
      finer.push_back(breaks[b]);
    }
    if (!room)
      throw InvalidInput(fmt::format(
          "degree {} along {} becomes {} only by moving the surface by up to {:.3g}, where {:.3g} is "
          "allowed; allow more, or fit with degree {}",
          s.degree_u(), name, degree, reduced.error, allowed, degree));
    breaks = std::move(finer);
  }
}

/// Where the surface folds or jumps along u.
std::vector<double> folds(const KnotVector& knots) {
  std::vector<double> at;
  for (const Break& b : breaks_of(knots))
    if (b.at > knots.first() && b.at < knots.last() && b.multiplicity >= knots.degree()) at.push_back(b.at);
  return at;
}

/// Cuts at knots, as late as pieces of at most `most` control points allow.
std::vector<double> cuts_for(const KnotVector& knots, Index most) {
  std::vector<double> cuts;
  const std::vector<Break> breaks = breaks_of(knots);
  Index count = knots.degree() + 1;
  for (std::size_t b = 1; b + 1 < breaks.size(); ++b) {
    // Control points of the piece if it went on to the next break.
    if (count + breaks[b].multiplicity > most) {
      cuts.push_back(breaks[b].at);
      count = knots.degree() + 1;
    } else {
      count += breaks[b].multiplicity;
    }
  }
  return cuts;
}

/// The fewest pieces, and among them the most even ones.
std::vector<double> even_cuts(const KnotVector& knots, Index most) {
  std::vector<double> cuts = cuts_for(knots, most);
  Index low = 2 * knots.degree(), high = most;  // the smallest limit with as many pieces
  while (low < high) {
    const Index middle = (low + high) / 2;
    std::vector<double> tried = cuts_for(knots, middle);
    if (tried.size() <= cuts.size()) {
      cuts = std::move(tried);
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return cuts;
}

/// One direction: split at folds, raised, split by size; u is the direction.
std::vector<Surface> faces_u(const Surface& s, const CadSafe& options) {
  std::vector<Surface> faces;
  for (const Surface& smooth : split_u(s, folds(s.knots_u()))) {
    const Surface raised = elevated_u(smooth, options.degree);
    for (Surface& face : split_u(raised, even_cuts(raised.knots_u(), options.most_control_points)))
      faces.push_back(std::move(face));
  }
  return faces;
}

void check(const Surface& s, const CadSafe& options) {
  if (s.empty()) throw InvalidInput("the surface to make safe for CAD is empty");
  if (options.degree < 1 || options.degree > kMaxDegree)
    throw InvalidInput(
        fmt::format("the degree of CAD faces is {}; it must be 1 to {}", options.degree, kMaxDegree));
  if (!(options.tolerance >= 0) || std::isinf(options.tolerance))
    throw InvalidInput(fmt::format("the tolerance of CAD faces is {}; it must be >= 0", options.tolerance));
  if (options.most_control_points < 2 * options.degree)
    throw InvalidInput(
        fmt::format("a CAD face of degree {} needs at least {} control points a direction, not {}",
                    options.degree, 2 * options.degree, options.most_control_points));
  if (!(options.least_knot_distance >= 0 && options.least_knot_distance <= 0.1))
    throw InvalidInput(fmt::format("the least distance of knots is {}; it must be within [0, 0.1]",
                                   options.least_knot_distance));
}

}  // namespace

std::vector<Surface> cad_safe(const Surface& surface, const CadSafe& options) {
  check(surface, options);
  Budget budget(options.tolerance, 256 * std::numeric_limits<double>::epsilon() * surface.scale(), 4);
  const auto prepared = [&](const Surface& s, char name) {
    Surface result = merged_u(s, options.least_knot_distance, budget, name);
    if (result.degree_u() > options.degree)
      result = reduced_u(result, options.degree, options.least_knot_distance, budget, name);
    return result;
  };
  // Before it is split, so that neighbours keep one border.
  Surface whole = prepared(clamped(surface), 'u');
  whole = transposed(prepared(transposed(whole), 'v'));
  std::vector<Surface> faces;
  for (const Surface& strip : faces_u(whole, options))
    for (const Surface& face : faces_u(transposed(strip), options)) faces.push_back(transposed(face));
  return faces;
}

}  // namespace knotfit
