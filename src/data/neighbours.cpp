#include "data/neighbours.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <utility>

#include "base/parallel.h"
namespace knotfit {
namespace {

constexpr std::size_t kLeaf = 16;  // points a leaf

// What nanoflann asks of a data set, over one strip; its indices are the strip's own.
struct Cloud {
  const double* x;
  const double* y;
  std::size_t size;
  std::size_t kdtree_get_point_count() const { return size; }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const { return axis == 0 ? x[k] : y[k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::uint32_t>;

// The k nearest so far, with the strip's offset added to each index: few in order, many as a heap whose top is the farthest.
class Nearest {
 public:
  using DistanceType = double;
  Nearest(std::span<std::uint32_t> index, std::span<double> squared)
      : index_(index), squared_(squared), many_(index.size() > kMany) {}
  std::size_t size() const { return many_ ? heap_.size() : count_; }
  bool full() const { return size() == index_.size(); }
  double worstDist() const { return !full() ? INFINITY : many_ ? heap_.front().first : squared_[count_ - 1]; }
  void set_offset(Index offset) { offset_ = static_cast<std::uint32_t>(offset); }
  bool addPoint(double squared, std::uint32_t index) {
    if (!(squared < worstDist())) return true;
    if (many_) {
      if (full()) std::pop_heap(heap_.begin(), heap_.end()), heap_.pop_back();
      heap_.emplace_back(squared, index + offset_);
      std::push_heap(heap_.begin(), heap_.end());
      return true;
    }
    std::size_t i = full() ? count_ - 1 : count_++;
    for (; i > 0 && squared_[i - 1] > squared; --i) squared_[i] = squared_[i - 1], index_[i] = index_[i - 1];
    squared_[i] = squared, index_[i] = index + offset_;
    return true;
  }
  /// Nearest first in the spans, once all are found.
  void finish() {
    std::sort_heap(heap_.begin(), heap_.end());
    for (std::size_t i = 0; i < heap_.size(); ++i) squared_[i] = heap_[i].first, index_[i] = heap_[i].second;
  }

 private:
  static constexpr std::size_t kMany = 128;  // from where shifting costs more than a heap
  std::span<std::uint32_t> index_;
  std::span<double> squared_;
  bool many_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
  std::size_t count_ = 0;
  std::uint32_t offset_ = 0;
};

}  // namespace

struct Neighbours::Strip {
  Index begin;
  double low, high;  // range of x
  Cloud cloud;
  Tree tree;
  Strip(const double* x, const double* y, Index begin_, Index size)
      : begin(begin_),
        low(*std::min_element(x, x + size)),
        high(*std::max_element(x, x + size)),
        cloud{x, y, static_cast<std::size_t>(size)},
        tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(kLeaf)) {}
};

Neighbours::Neighbours(std::vector<double> x, std::vector<double> y, std::vector<Index> strip_start)
    : x_(std::move(x)), y_(std::move(y)) {
  const Index strips = static_cast<Index>(strip_start.size()) - 1;
  strips_.resize(static_cast<std::size_t>(strips));
  parallel_for(strips, [&](Index s) {
    const Index begin = strip_start[s], size = strip_start[s + 1] - begin;
    if (size > 0) strips_[s] = std::make_unique<Strip>(x_.data() + begin, y_.data() + begin, begin, size);
  });
  std::erase(strips_, nullptr);
}

Neighbours::~Neighbours() = default;
Neighbours::Neighbours(Neighbours&&) noexcept = default;

Index Neighbours::nearest(double x, double y, std::span<std::uint32_t> index,
                          std::span<double> squared) const {
  Nearest found(index, squared);
  const double place[2] = {x, y};
  auto search = [&](const Strip& strip) {
    const double off = std::max({0.0, strip.low - x, x - strip.high});
    if (!(off * off < found.worstDist())) return false;
    found.set_offset(strip.begin);
    strip.tree.findNeighbors(found, place, nanoflann::SearchParams());
    return true;
  };
  // Outwards from the strip of x; strips beyond one that is too far are farther still.
  const Index strips = static_cast<Index>(strips_.size());
  Index home = 0;
  while (home + 1 < strips && strips_[home + 1]->low <= x) ++home;
  for (Index s = home; s < strips && search(*strips_[s]);) ++s;
  for (Index s = home - 1; s >= 0 && search(*strips_[s]);) --s;
  found.finish();
  return static_cast<Index>(found.size());
}

double Neighbours::gap(double x, double y) const {
  std::uint32_t index;
  double squared = INFINITY;
  nearest(x, y, {&index, 1}, {&squared, 1});
  return std::sqrt(squared);
}

Neighbours plain_neighbours(const DistinctPoints& points) {
  return {points.u, points.v, points.strip_start};
}

}  // namespace knotfit
