#include "parameterize/mesh_border.h"

#include <algorithm>
#include <cmath>
#include <numeric>
namespace knotfit::mesh_map {

Border::Border(const DiskMesh& disk, const std::vector<RestTriangle>& rest) : disk_(disk) {
  std::vector<double> by_edge(disk.edge.size(), 0);
  for (int f = 0; f < disk.face_count(); ++f)
    for (int k = 0; k < 3; ++k) by_edge[disk.face_edge[f][k]] = rest[f].length[k];
  for (const int e : disk.loop_edge) length_.push_back(by_edge[e]);
  add_up();
}

void Border::add_up() {
  sum_.assign(1, 0.0);
  for (const double l : length_) sum_.push_back(sum_.back() + l);
}

void Border::stretch(std::span<const double> factors) {
  for (int k = 0; k < size(); ++k) length_[k] *= factors[k];
  add_up();
}

int Border::edge_at(double arc, double& along) const {
  arc -= total() * std::floor(arc / total());
  const auto after = std::upper_bound(sum_.begin(), sum_.end(), arc);
  const int k = std::clamp(static_cast<int>(after - sum_.begin()) - 1, 0, size() - 1);
  along = std::clamp((arc - sum_[k]) / length_[k], 0.0, 1.0);
  return k;
}

int Border::nearest(double arc) const {
  double along = 0;
  const int k = edge_at(arc, along);
  return along < 0.5 ? k : (k + 1) % size();
}

void Border::place(const Corners& corners, std::span<double> uv) const {
  constexpr double square[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  for (int side = 0; side < 4; ++side) {
    const int begin = corners[side], end = corners[(side + 1) % 4];
    double whole = 0, part = 0;
    for (int k = begin; k != end; k = (k + 1) % size()) whole += length_[k];
    const int axis = side % 2;
    for (int k = begin; k != end; k = (k + 1) % size()) {
      double* p = &uv[2 * static_cast<std::size_t>(disk_.loop[k])];
      const double share = part / whole;
      p[1 - axis] = square[side][1 - axis];
      p[axis] = side < 2 ? share : 1 - share;
      part += length_[k];
    }
  }
}

Corners sharpest_corners(const Border& border) {
  constexpr double window = 0.02, apart = 0.08;
  const DiskMesh& disk = border.disk();
  const int n = border.size();
  auto point = [&](double arc) {
    double t = 0;
    const int k = border.edge_at(arc, t);
    const Position &a = disk.position[disk.loop[k]], &b = disk.position[disk.loop[(k + 1) % n]];
    return Position{(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]};
  };
  std::vector<double> turn(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) {
    const Position &p = disk.position[disk.loop[k]], &normal = disk.normal[disk.loop[k]];
    const Position a = point(border.at(k) - window * border.total()),
                   b = point(border.at(k) + window * border.total());
    const double x[3] = {p[0] - a[0], p[1] - a[1], p[2] - a[2]},
                 y[3] = {b[0] - p[0], b[1] - p[1], b[2] - p[2]};
    const double sine = (x[1] * y[2] - x[2] * y[1]) * normal[0] + (x[2] * y[0] - x[0] * y[2]) * normal[1] +
                        (x[0] * y[1] - x[1] * y[0]) * normal[2];
    turn[k] = std::atan2(sine, x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
  }
  std::vector<int> order(static_cast<std::size_t>(n)), picked;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return turn[a] > turn[b]; });
  for (double gap = apart * border.total(); picked.size() < 4; gap *= 0.7) {
    picked.clear();
    for (const int k : order) {
      const bool free = std::all_of(picked.begin(), picked.end(), [&](int other) {
        const double d = std::abs(border.at(k) - border.at(other));
        return std::min(d, border.total() - d) >= gap && k != other;
      });
      if (free) picked.push_back(k);
      if (picked.size() == 4) break;
    }
  }
  std::sort(picked.begin(), picked.end());
  return {picked[0], picked[1], picked[2], picked[3]};
}

Corners corners_at_ears(const Border& border, Corners corners) {
  constexpr double near = 0.02;
  const DiskMesh& disk = border.disk();
  std::vector<int> faces(disk.position.size(), 0);
  for (const Face& t : disk.own_face)
    for (const int i : t) ++faces[i];
  const auto ear = [&](int k) { return faces[disk.loop[k]] == 1; };
  for (int k = 0; k < border.size(); ++k) {
    if (!ear(k) || std::find(corners.begin(), corners.end(), k) != corners.end()) continue;
    const auto distance = [&](int corner) {
      const double d = std::abs(border.at(corner) - border.at(k));
      return std::min(d, border.total() - d);
    };
    const auto nearest = std::min_element(corners.begin(), corners.end(),
                                          [&](int a, int b) { return distance(a) < distance(b); });
    // No corner lies between the nearest one and its new place: their order stays.
    if (!ear(*nearest) && distance(*nearest) <= near * border.total()) *nearest = k;
  }
  return corners;
}

std::vector<char> fixed_coordinates(const DiskMesh& disk, std::span<const double> uv) {
  std::vector<char> fixed(disk.position.size(), 0);
  for (const int i : disk.loop)
    for (int axis = 0; axis < 2; ++axis) {
      const double x = uv[2 * static_cast<std::size_t>(i) + axis];
      if (x == 0 || x == 1) fixed[i] = static_cast<char>(fixed[i] | (1 << axis));
    }
  return fixed;
}

}  // namespace knotfit::mesh_map
