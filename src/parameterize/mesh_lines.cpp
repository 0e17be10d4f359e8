#include <fmt/format.h>

#include <algorithm>

#include "data/mesh_data.h"
#include "knotfit/exceptions.h"
#include "knotfit/parameterize_mesh.h"
namespace knotfit {
namespace {

using Polyline = std::vector<std::array<double, 3>>;

struct Crossing {
  std::int32_t low, high;  // edge crossed
  Index face;
  bool operator<(const Crossing& other) const {
    return low != other.low ? low < other.low : high != other.high ? high < other.high : face < other.face;
  }
  bool same_edge(const Crossing& other) const { return low == other.low && high == other.high; }
};

class LineTracer {
 public:
  LineTracer(const Mesh& mesh, const std::vector<double>& uv) : mesh_(mesh), uv_(uv) {}

  // The line on which coordinate `axis` is `value`, from where the other is least.
  Polyline trace(int axis, double value) const {
    // A vertex on the line counts as beyond it, on the last line as before it: no edge is met at two
    // places, and border lines are met at all.
    const auto beyond = [&](std::int32_t i) {
      const double x = uv_[2 * static_cast<std::size_t>(i) + axis];
      return value < 0.5 ? x > value : x >= value;
    };
    std::vector<Crossing> crossings;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const auto& t = mesh_.faces[f];
      for (int k = 0; k < 3; ++k) {
        const std::int32_t a = t[k], b = t[(k + 1) % 3];
        if (beyond(a) != beyond(b)) crossings.push_back({std::min(a, b), std::max(a, b), f});
      }
    }
    std::sort(crossings.begin(), crossings.end());
    return chain(crossings, axis, value);
  }

 private:
  Polyline chain(const std::vector<Crossing>& crossings, int axis, double value) const {
    const std::size_t n = crossings.size();
    std::vector<std::array<std::size_t, 2>> of_face(static_cast<std::size_t>(mesh_.face_count()), {n, n});
    for (std::size_t k = 0; k < n; ++k) {
      auto& slots = of_face[crossings[k].face];
      slots[slots[0] == n ? 0 : 1] = k;
    }
    const auto across = [&](std::size_t k) {  // the same edge seen from its other face
      if (k > 0 && crossings[k - 1].same_edge(crossings[k])) return k - 1;
      if (k + 1 < n && crossings[k + 1].same_edge(crossings[k])) return k + 1;
      return n;
    };
    std::size_t start = n;
    double least = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (across(k) != n) continue;
      const double other = at(crossings[k], axis, value, uv_.data(), 2)[1 - axis];
      if (start == n || other < least) start = k, least = other;
    }
    Polyline line;
    const auto add = [&](std::size_t k) {
      const auto p = at(crossings[k], axis, value, mesh_.vertices.data(), 3);
      if (line.empty() || line.back() != p) line.push_back(p);
    };
    for (std::size_t k = start, steps = 0; k < n && steps <= n; k = across(k), ++steps) {
      add(k);
      const auto& slots = of_face[crossings[k].face];
      k = slots[0] == k ? slots[1] : slots[0];
      if (k >= n) break;
      add(k);
    }
    return line;
  }

  std::array<double, 3> at(const Crossing& c, int axis, double value, const double* values, int size) const {
    const double x = uv_[2 * static_cast<std::size_t>(c.low) + axis],
                 y = uv_[2 * static_cast<std::size_t>(c.high) + axis];
    const double t = std::clamp((value - x) / (y - x), 0.0, 1.0);
    std::array<double, 3> p{};
    for (int k = 0; k < size; ++k) {
      const double a = values[size * static_cast<std::ptrdiff_t>(c.low) + k];
      const double b = values[size * static_cast<std::ptrdiff_t>(c.high) + k];
      p[k] = t == 1 ? b : a + t * (b - a);
    }
    return p;
  }

  const Mesh& mesh_;
  const std::vector<double>& uv_;
};

}  // namespace

std::vector<Polyline> parameter_lines(const Mesh& mesh, const std::vector<double>& uv, int count) {
  require_parameters(mesh, uv);
  if (count < 1)
    throw InvalidInput(fmt::format("{} parts between parameter lines: ask for at least 1", count));
  const LineTracer tracer(mesh, uv);
  std::vector<Polyline> lines;
  for (const int axis : {0, 1})
    for (int k = 0; k <= count; ++k) lines.push_back(tracer.trace(axis, static_cast<double>(k) / count));
  return lines;
}

}  // namespace knotfit
