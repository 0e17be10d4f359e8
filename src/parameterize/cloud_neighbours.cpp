#include "parameterize/cloud_neighbours.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>
#include <queue>

#include "base/parallel.h"
#include "parameterize/cloud_lines.h"
namespace knotfit::cloud {
namespace {

// What nanoflann asks of a data set.
struct Cloud {
  const double* x;
  std::size_t size, dimension;
  std::size_t kdtree_get_point_count() const { return size; }
  double kdtree_get_pt(std::size_t k, std::size_t axis) const { return x[k * dimension + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

template <int dimension>
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 dimension, std::uint32_t>;

/// The nearest others of a point.
template <int dimension>
class Others {
 public:
  Others(const Tree<dimension>& tree, std::span<const double> points) : tree_(tree), points_(points) {}
  void find(Index k, std::size_t count, Nearest& nearest) {
    // One more than asked for: the point itself, or one at the same place, is among them.
    found_.resize(count + 1);
    far_.resize(count + 1);
    const std::size_t all =
        tree_.knnSearch(points_.data() + k * dimension, count + 1, found_.data(), far_.data());
    nearest.index.clear(), nearest.squared.clear();
    for (std::size_t i = 0; i < all && nearest.index.size() < count; ++i)
      if (found_[i] != static_cast<std::uint32_t>(k))
        nearest.index.push_back(found_[i]), nearest.squared.push_back(far_[i]);
  }

 private:
  const Tree<dimension>& tree_;
  std::span<const double> points_;
  std::vector<std::uint32_t> found_;
  std::vector<double> far_;
};

template <int dimension>
void search(std::span<const double> points, NeighbourLists& lists, bool across_lines) {
  const Cloud cloud{points.data(), points.size() / dimension, dimension};
  const Tree<dimension> tree(dimension, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  const auto count = static_cast<std::size_t>(lists.count);
  parallel_for(static_cast<Index>(cloud.size), [&](Index k) {
    Others<dimension> others(tree, points);
    Nearest nearest;
    others.find(k, count, nearest);
    if (dimension == 3 && across_lines)
      reach_across(points, k, nearest,
                   [&](std::size_t wanted, Nearest& pool) { others.find(k, wanted, pool); });
    const auto to = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * count);
    std::copy_n(nearest.index.begin(), count, lists.index.begin() + to);
    std::copy_n(nearest.squared.begin(), count, lists.squared.begin() + to);
  });
}

NeighbourLists lists_of(std::span<const double> points, int dimension, int count, bool across_lines) {
  NeighbourLists lists;
  lists.count = count;
  const std::size_t n = points.size() / static_cast<std::size_t>(dimension);
  lists.index.assign(n * static_cast<std::size_t>(count), 0);
  lists.squared.assign(n * static_cast<std::size_t>(count), 0);
  if (dimension == 2)
    search<2>(points, lists, false);
  else
    search<3>(points, lists, across_lines);
  return lists;
}

}  // namespace

std::array<Vector, 2> frame_of(const Vector& axis) {
  using Eigen::Vector3d;
  const Vector3d n(axis.data());
  const Vector3d towards = std::abs(n[0]) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d first = (towards - towards.dot(n) * n).normalized(), second = n.cross(first);
  return {Vector{first[0], first[1], first[2]}, Vector{second[0], second[1], second[2]}};
}

NeighbourLists nearest_neighbours(std::span<const double> points, int dimension, int count) {
  return lists_of(points, dimension, count, false);
}

NeighbourLists neighbours_across_lines(std::span<const double> points, int count) {
  return lists_of(points, 3, count, true);
}

Axes principal_axes(std::span<const double> points, std::span<const std::uint32_t> index) {
  const Index n = index.empty() ? static_cast<Index>(points.size()) / 3 : static_cast<Index>(index.size());
  const auto at = [&](Index k) {
    return Eigen::Map<const Eigen::Vector3d>(points.data() + 3 * (index.empty() ? k : Index{index[k]}));
  };
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (Index k = 0; k < n; ++k) centre += (at(k) - at(0)) / static_cast<double>(n);
  centre += at(0);
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (Index k = 0; k < n; ++k) m += (at(k) - centre) * (at(k) - centre).transpose() / static_cast<double>(n);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  Axes axes;
  for (int c = 0; c < 3; ++c) {
    axes.centre[c] = centre[c];
    axes.variance[c] = solver.eigenvalues()[c];
    for (int d = 0; d < 3; ++d) axes.axis[c][d] = solver.eigenvectors()(d, c);
  }
  return axes;
}

std::vector<Vector> agreeing_normals(std::span<const double> points, const NeighbourLists& neighbours) {
  const Index n = static_cast<Index>(points.size()) / 3;
  std::vector<Vector> normal(static_cast<std::size_t>(n));
  parallel_for(n, [&](Index k) {
    std::vector<std::uint32_t> some(neighbours.of(k), neighbours.of(k) + neighbours.count);
    some.push_back(static_cast<std::uint32_t>(k));
    normal[k] = principal_axes(points, some).axis[0];
  });
  // Cosine of one normal with the other mirrored across the middle of both points: 1 along a circle, and between the
  // two sides of a thin sheet or of lips that touch [Konig09].
  const auto agreement = [&](std::size_t a, std::size_t b) {
    Vector d{};
    for (std::size_t c = 0; c < 3; ++c) d[c] = points[3 * b + c] - points[3 * a + c];
    const double square = dot(d, d), cosine = dot(normal[a], normal[b]);
    return square > 0 ? cosine - 2 * dot(normal[a], d) * dot(normal[b], d) / square : cosine;
  };
  // Prim's algorithm from every point not yet reached; neighbours count both ways.
  std::vector<std::vector<std::uint32_t>> also(static_cast<std::size_t>(n));
  for (Index k = 0; k < n; ++k)
    for (int i = 0; i < neighbours.count; ++i)
      also[neighbours.of(k)[i]].push_back(static_cast<std::uint32_t>(k));
  struct Step {
    double apart;
    std::uint32_t from, to;
    bool operator<(const Step& o) const {
      return apart != o.apart ? apart > o.apart : to != o.to ? to > o.to : from > o.from;
    }
  };
  std::vector<char> done(static_cast<std::size_t>(n), 0);
  std::priority_queue<Step> queue;
  const auto reach = [&](std::uint32_t k) {
    done[k] = 1;
    const auto push = [&](std::uint32_t to) {
      if (done[to] == 0) queue.push({1 - std::abs(agreement(k, to)), k, to});
    };
    for (int i = 0; i < neighbours.count; ++i) push(neighbours.of(k)[i]);
    for (const std::uint32_t to : also[k]) push(to);
  };
  for (Index first = 0; first < n; ++first) {
    if (done[first] != 0) continue;
    reach(static_cast<std::uint32_t>(first));
    while (!queue.empty()) {
      const Step step = queue.top();
      queue.pop();
      if (done[step.to] != 0) continue;
      if (agreement(step.from, step.to) < 0)
        for (double& x : normal[step.to]) x = -x;
      reach(step.to);
    }
  }
  return normal;
}

std::vector<Vector> agreeing_normals(std::span<const double> points, const NeighbourLists& neighbours,
                                     std::span<const double> given) {
  std::vector<Vector> normals = agreeing_normals(points, neighbours);
  if (given.empty()) return normals;
  const auto given_of = [&](std::size_t k) {
    return Vector{given[3 * k], given[3 * k + 1], given[3 * k + 2]};
  };
  Index sides = 0;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const double side = dot(normals[k], given_of(k));
    sides += (side > 0) - (side < 0);
  }
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector n = given_of(k);
    const double length = std::hypot(n[0], n[1], n[2]), factor = length > 0 ? 1 / length : sides < 0 ? -1 : 1;
    for (std::size_t c = 0; c < 3; ++c) normals[k][c] = factor * (length > 0 ? n[c] : normals[k][c]);
  }
  return normals;
}

}  // namespace knotfit::cloud
