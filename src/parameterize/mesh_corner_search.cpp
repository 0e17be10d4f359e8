#include "parameterize/mesh_corner_search.h"

#include <algorithm>
#include <limits>
#include <map>
namespace knotfit::mesh_map {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Costs of corners, each worked out once.
class Costs {
 public:
  Costs(int border_size, const CornerSearch& search, const std::function<double(const Corners&)>& cost)
      : size_(border_size), search_(search), cost_(cost) {}
  double operator()(const Corners& corners) {
    int around = 0;  // the corners must go round once, and no side be empty
    for (int k = 0; k < 4; ++k) {
      const int step = (corners[(k + 1) % 4] - corners[k] + size_) % size_;
      if (step == 0) return kNone;
      around += step;
    }
    if (around != size_) return kNone;
    // The same four vertices with another one first: the square turned, the same cost.
    Corners key = corners;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    if (spent()) return kNone;
    return known_[key] = cost_(corners);
  }
  bool spent() const {
    return static_cast<int>(known_.size()) >= search_.most_evaluations || (search_.stop && search_.stop());
  }

 private:
  int size_;
  const CornerSearch& search_;
  const std::function<double(const Corners&)>& cost_;
  std::map<Corners, double> known_;
};

struct Found {
  double cost;
  Corners corners;
};

void descend(const Border& border, Costs& costs, Found& best) {
  constexpr int moves[] = {1, 2, 4, 8, 3, 6, 12, 9, 15};  // bits: the corners that move
  for (double step = border.total() / 12; step > border.total() / 300; step /= 2)
    for (bool moved = true; moved && !costs.spent();) {
      moved = false;
      for (const int move : moves)
        for (const double sign : {1.0, -1.0}) {
          Corners trial = best.corners;
          for (int k = 0; k < 4; ++k)
            if (move >> k & 1) trial[k] = border.nearest(border.at(best.corners[k]) + sign * step);
          const double cost = costs(trial);
          if (cost < best.cost * (1 - 1e-9)) {
            best = {cost, trial};
            moved = true;
          }
        }
    }
}

}  // namespace

Corners search_corners(const Border& border, const CornerSearch& search,
                       const std::function<double(const Corners&)>& cost) {
  Costs costs(border.size(), search, cost);
  std::vector<Corners> starts = search.starts;
  for (int turn = 0; turn < 8; ++turn) {
    Corners quarters;
    for (int k = 0; k < 4; ++k) quarters[k] = border.nearest(border.total() * (k / 4.0 + turn / 32.0));
    starts.push_back(quarters);
  }
  std::vector<Found> found;
  found.reserve(starts.size());
  for (const Corners& corners : starts) found.push_back({costs(corners), corners});
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.cost < b.cost; });
  found.resize(2);
  for (Found& start : found)
    if (start.cost < kNone) descend(border, costs, start);
  return found[1].cost < found[0].cost ? found[1].corners : found[0].corners;
}

}  // namespace knotfit::mesh_map
