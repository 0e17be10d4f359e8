#include "search/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/evaluate.h"
#include "search/cover.h"
namespace knotfit {
namespace {

// Measured constants [METHOD 4.4].
constexpr double kRadius = 1, kBorder = 0.5;  // of the fill
constexpr double kReserveRadius = 0.7, kReserveBorder = 0.4;
constexpr double kWeight = 0.3, kSlack = 1.25, kJoin = 1.02;
// Error bars beyond this many tolerances say nothing. Below it even an unsure reference keeps a surface from
// swinging through a hole, with the little weight that its bar leaves it.
constexpr double kDrop = 1e4;
// A place matters where the gap is above this share of the cell's shorter side, or the cell holds fewer points.
constexpr double kWideGap = 0.12;
constexpr Index kFewPoints = 60;

double infinity() {
  return std::numeric_limits<double>::infinity();
}

}  // namespace

Guard::Guard(JoinedPoints& joined, double tolerance, double loose, const InteriorKnots& metric,
             std::function<bool()> stop)
    : tolerance_(tolerance),
      loose_(loose),
      stop_(std::move(stop)),
      field_(joined.points(), tolerance, metric.u, metric.v, 1),
      joined_(joined) {
  for (bool fill : {true, false})
    for (const auto& place : fill ? cover_gaps(field_.neighbours(), kRadius, kBorder)
                                  : cover_gaps(field_.neighbours(), kReserveRadius, kReserveBorder))
      if (joined.points().map.covers(place[0], place[1])) watch(place, fill);
}

void Guard::watch(const std::array<double, 2>& place, bool fill) {
  sites_.push_back(
      {.place = place, .gap = field_.neighbours().gap(place[0], place[1]), .fill = fill, .reference = {}});
}

double Guard::slack(const Site& site) const {
  const double e = site.reference.error_bar / tolerance_;
  return e > 1 || site.reference.gap > verify::kHole ? infinity() : kSlack + e;
}

std::vector<Index> Guard::sites_that_matter(MovingFit& problem, bool fill_only) {
  const ParameterizedPoints& points = joined_.points();
  const Axis &u = problem.axis_u(), &v = problem.axis_v();
  std::vector<Index> count(u.spans() * v.spans(), 0);
  for (Index k = 0; k < points.size(); ++k) ++count[u.span(points.u(k)) * v.spans() + v.span(points.v(k))];
  std::vector<Index> here, unknown;
  for (Index i = 0; i < static_cast<Index>(sites_.size()); ++i) {
    const Site& site = sites_[i];
    if (site.state == Site::joined || (fill_only && !site.fill)) continue;
    const Index a = u.span(site.place[0]), b = v.span(site.place[1]);
    if (site.gap <= kWideGap * std::min(u.length(a), v.length(b)) && count[a * v.spans() + b] >= kFewPoints)
      continue;
    here.push_back(i);
    if (site.state == Site::open) unknown.push_back(i);
  }
  std::vector<verify::Place> places;
  places.reserve(unknown.size());
  for (Index i : unknown) places.push_back(sites_[i].place);
  const auto references = field_.at(places, [&](Index) { return !stop_ || !stop_(); });
  for (std::size_t i = 0; i < references.size(); ++i) {
    sites_[unknown[i]].reference = references[i];
    sites_[unknown[i]].state = Site::known;
  }
  std::erase_if(here, [&](Index i) {  // stopped, or nothing to hold to
    return sites_[i].state != Site::known || !(sites_[i].reference.error_bar <= kDrop * tolerance_);
  });
  return here;
}

void Guard::join(Site& site) {
  const double e = site.reference.error_bar / tolerance_;
  joined_.join(site.place[0], site.place[1], site.reference.value.data(), kWeight / (1 + 4 * e * e),
               slack(site));
  site.state = Site::joined;
  ++fill_count_;
}

Index Guard::fill(MovingFit& problem) {
  const std::vector<Index> sites = sites_that_matter(problem, true);
  for (Index i : sites) join(sites_[i]);
  return static_cast<Index>(sites.size());
}

void Guard::watch_empty_cells(MovingFit& problem) {
  const ParameterizedPoints& points = joined_.points();
  const Axis &u = problem.axis_u(), &v = problem.axis_v();
  std::vector<char> held(u.spans() * v.spans(), 0);
  auto cell = [&](double x, double y) { return u.span(x) * v.spans() + v.span(y); };
  for (Index k = 0; k < points.size(); ++k) held[cell(points.u(k), points.v(k))] = 1;
  for (const Site& site : sites_) held[cell(site.place[0], site.place[1])] = 1;
  for (Index a = 0; a < u.spans(); ++a)
    for (Index b = 0; b < v.spans(); ++b) {
      if (held[a * v.spans() + b] || !(u.length(a) > 0) || !(v.length(b) > 0)) continue;
      const std::array<double, 2> place{u.low(a) + u.length(a) / 2, v.low(b) + v.length(b) / 2};
      if (points.map.covers(place[0], place[1])) watch(place, false);
    }
}

Index Guard::exchange(MovingFit& problem) {
  watch_empty_cells(problem);
  const std::vector<Index> sites = sites_that_matter(problem, false);
  std::vector<double> uv;
  for (Index i : sites) uv.insert(uv.end(), sites_[i].place.begin(), sites_[i].place.end());
  const std::vector<double> values = evaluate(problem.surface(), uv);
  const int d = joined_.points().dimension;
  Index count = 0;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    Site& site = sites_[sites[k]];
    double square = 0;
    for (int e = 0; e < d; ++e) {
      const double r = values[k * d + e] - site.reference.value[e];
      square += r * r;
    }
    if (std::sqrt(square) <= kJoin * slack(site) * loose_ * tolerance_) continue;
    join(site);
    ++count;
  }
  return count;
}

}  // namespace knotfit
