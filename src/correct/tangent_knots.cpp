// Variable projection of the tangent step [Golub73; Kaufman75; METHOD 3.1, 8.11].
#include <array>

#include "correct/tangent_system.h"
#include "fit/knot_basis.h"
namespace knotfit::correction {
std::optional<KnotJacobian> TangentSystem::knot_jacobian(const SystemPoints& points, double smoothing,
                                                         const Holding& holding, const Surface& surface,
                                                         std::span<const char> counts) const {
  const Sum sum = summed(points, holding);
  const std::optional<BandMatrix> factor = factored(sum, std::max(smoothing, 1e-12));
  if (!factor) return std::nullopt;

  const Index ku = u_.spans() - 1, kv = v_.spans() - 1, count = ku + kv;
  const int wu = u_.width(), wv = v_.width();
  const std::vector<double> tables_u = knot_derivatives(u_), tables_v = knot_derivatives(v_);
  KnotJacobian result;
  result.knots = static_cast<std::size_t>(count);
  result.matrix.assign(static_cast<std::size_t>(count * count), 0.0);
  result.gradient.assign(static_cast<std::size_t>(count), 0.0);
  const Index size = energy_.size();
  Panel projected(3 * size, count), of_data(3 * size, count);
  std::vector<double> pull(static_cast<std::size_t>(3 * size), 0.0);  // A^T W r of the data
  struct Column {
    Index knot;
    Vec3 d, weighted;
  };
  std::vector<Column> columns;
  KnotBasis bu, bv;
  for (std::size_t k = 0; k < points.weight.size(); ++k) {
    if (!(points.weight[k] > 0)) continue;
    bu.set(u_, tables_u, points.uv[2 * k]);
    bv.set(v_, tables_v, points.uv[2 * k + 1]);
    std::array<Vec3, kMaxDegree + 1> along_u{}, along_v{};  // control points summed over the other direction
    Vec3 s;
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j) {
        const Vec3 c = at(surface.control_point(bu.span + i, bv.span + j).data());
        along_u[i] += bv.value[j] * c;
        along_v[j] += bu.value[i] * c;
      }
    for (int i = 0; i < wu; ++i) s += bu.value[i] * along_u[i];
    const Vec3 r = points.weight[k] * (points.matrix[k] * (s - points.point[k]));
    columns.clear();
    const auto add = [&](Index knot, Index most, Index first, int w, const auto& by_knot, const auto& along) {
      if (knot < 0 || knot >= most) return;
      Vec3 d;
      for (int i = 0; i < w; ++i) d += by_knot[i] * along[i];
      columns.push_back({first + knot, d, points.weight[k] * (points.matrix[k] * d)});
    };
    for (int e = 0; e < 2 * u_.degree(); ++e)
      add(bu.span - u_.degree() + e, ku, 0, wu, bu.by_knot[e], along_u);
    for (int e = 0; e < 2 * v_.degree(); ++e)
      add(bv.span - v_.degree() + e, kv, ku, wv, bv.by_knot[e], along_v);
    if (counts[k])
      for (const Column& c : columns) {
        result.gradient[c.knot] += dot(c.d, r);
        for (const Column& o : columns) result.matrix[o.knot * count + c.knot] += dot(o.d, c.weighted);
      }
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j) {
        const Index row = 3 * index(bu.span + i, bv.span + j);
        const double f = bu.value[i] * bv.value[j];
        for (Panel* panel : {&projected, counts[k] ? &of_data : nullptr})
          if (panel != nullptr)
            for (const Column& c : columns) {
              (*panel)(row, c.knot) += f * c.weighted.x;
              (*panel)(row + 1, c.knot) += f * c.weighted.y;
              (*panel)(row + 2, c.knot) += f * c.weighted.z;
            }
        if (counts[k]) pull[row] += f * r.x, pull[row + 1] += f * r.y, pull[row + 2] += f * r.z;
      }
  }
  // The control points minimise more than the data's sum: its slope in them does not vanish, and counts.
  factor->solve(pull.data(), 1);
  for (Index k = 0; k < count; ++k)
    for (Index row = 0; row < 3 * size; ++row) result.gradient[k] -= projected(row, k) * pull[row];
  factor->forward(of_data);
  of_data.add_gram(0, count, -1, result.matrix.data());
  return result;
}

}  // namespace knotfit::correction
