#include "verify/gap_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "base/parallel.h"
#include "verify/local_reference.h"
#include "verify/random.h"
namespace knotfit::verify {
namespace {

constexpr Index kLeastCells = 64, kMostCells = 200;
constexpr double kBorder = 2;  // the guard's cover is twice as dense on the border [METHOD 4.4]
// A hole by the rule of the local reference, for points spread evenly: 0.35 h, pi h^2 density = 80.
const double kHoleSpacings = kHole * std::sqrt(static_cast<double>(kPlainShape.points) / std::numbers::pi);

struct Candidate {
  double u = 0, v = 0;
  double unit = 0;         // local spacings a length, doubled on the border
  double gap = 0;          // distance to the nearest point or place
  std::size_t places = 0;  // places that `gap` knows
};

// Points a unit of area about a place: counts of coarse cells, 3 x 3 together.
class Density {
 public:
  explicit Density(const Neighbours& points)
      : cells_(
            std::clamp<Index>(static_cast<Index>(std::sqrt(static_cast<double>(points.size()) / 16)), 1, 64)),
        count_(static_cast<std::size_t>(cells_ * cells_), 0) {
    for (Index k = 0; k < points.size(); ++k) ++count_[cell(points.x(k)) * cells_ + cell(points.y(k))];
  }
  double operator()(double u, double v) const {
    const Index i = cell(u), j = cell(v);
    Index sum = 0, area = 0;
    for (Index a = std::max<Index>(0, i - 1); a <= std::min(cells_ - 1, i + 1); ++a)
      for (Index b = std::max<Index>(0, j - 1); b <= std::min(cells_ - 1, j + 1); ++b)
        sum += count_[a * cells_ + b], ++area;
    return static_cast<double>(sum) * static_cast<double>(cells_ * cells_) / static_cast<double>(area);
  }

 private:
  Index cell(double x) const {
    return std::clamp<Index>(static_cast<Index>(x * static_cast<double>(cells_)), 0, cells_ - 1);
  }
  Index cells_;
  std::vector<Index> count_;
};

std::vector<Candidate> candidates(Index cells, unsigned long long seed) {
  std::vector<Candidate> result;
  Random random(seed, Random::Stream::gaps);
  const double step = 1 / static_cast<double>(cells);
  for (double u : {0.0, 1.0})
    for (double v : {0.0, 1.0}) result.push_back({u, v, kBorder});
  for (Index i = 0; i < cells; ++i)
    for (int side = 0; side < 4; ++side) {
      const double x = (static_cast<double>(i) + random()) * step, end = side % 2;
      side < 2 ? result.push_back({x, end, kBorder}) : result.push_back({end, x, kBorder});
    }
  for (Index i = 0; i < cells; ++i)
    for (Index j = 0; j < cells; ++j) {
      const double u = (static_cast<double>(i) + random()) * step;
      result.push_back({u, (static_cast<double>(j) + random()) * step, 1});
    }
  return result;
}

}  // namespace

std::vector<std::array<double, 2>> gap_places(const Neighbours& points, Index count,
                                              unsigned long long seed) {
  std::vector<std::array<double, 2>> places;
  if (count <= 0 || points.size() == 0) return places;
  const auto wished = static_cast<Index>(4 * std::sqrt(static_cast<double>(points.size())));
  std::vector<Candidate> all = candidates(std::clamp(wished, kLeastCells, kMostCells), seed);
  const Density density(points);
  parallel_chunks(static_cast<Index>(all.size()), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      Candidate& c = all[i];
      const double spacings = std::sqrt(density(c.u, c.v));
      c.gap = points.gap(c.u, c.v);
      c.unit *= c.gap * spacings > kHoleSpacings ? 0 : spacings;
    }
  });

  // Farthest first; a candidate's gap is brought up to date when its turn comes.
  using Entry = std::pair<double, Index>;
  std::vector<Entry> entries;
  for (Index i = 0; i < static_cast<Index>(all.size()); ++i)
    entries.emplace_back(all[i].unit * all[i].gap, -i);
  std::priority_queue<Entry> queue(std::less<Entry>(), std::move(entries));
  while (!queue.empty() && static_cast<Index>(places.size()) < count) {
    const Index i = -queue.top().second;
    queue.pop();
    Candidate& c = all[i];
    const double before = c.gap;
    for (; c.places < places.size(); ++c.places)
      c.gap = std::min(c.gap, std::hypot(places[c.places][0] - c.u, places[c.places][1] - c.v));
    if (c.gap < before)
      queue.emplace(c.unit * c.gap, -i);
    else
      places.push_back({c.u, c.v});
  }
  return places;
}

}  // namespace knotfit::verify
