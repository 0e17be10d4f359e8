// Closest points of a surface, and distances between it and a mesh.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bind.h"
#include "knotfit/closest_point.h"
#include "knotfit/distance.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "run.h"
#include "tool/surface_file.h"
namespace knotfit::python {
namespace {

py::dict summary_of(const DistanceSummary& s) {
  py::dict d;
  d["count"] = s.count;
  d["rms"] = s.rms, d["max"] = s.max, d["mean"] = s.mean, d["median"] = s.median;
  d["p95"] = s.p95, d["p99"] = s.p99;
  d["signed_mean"] = s.signed_mean, d["deviation"] = s.deviation;
  d["worst_point"] = py::make_tuple(s.worst_point[0], s.worst_point[1], s.worst_point[2]);
  return d;
}

Surface space(const SurfaceDocument& d) {
  return tool::surface_in_space(d, "the surface is neither in space nor a height field");
}

/// (parameters in [0,1], points, distances, None), or with what was raised.
py::tuple nearest(const SurfaceDocument& d, const Array& points, int threads) {
  const Surface surface = space(d);
  ClosestPoints found;
  const py::object raised = run({.threads = threads, .progress = py::none()}, [&](const Control& control) {
    found = closest_points(surface, span_of(points), {}, control);
  });
  const auto n = static_cast<py::ssize_t>(found.distances.size());
  return py::make_tuple(array_of(std::move(found.uv), {n, 2}), array_of(std::move(found.points), {n, 3}),
                        array_of(std::move(found.distances)), raised);
}

/// (of the vertices: signed distances (n,), summary; of the surface: summary; what was raised).
py::tuple distance(const SurfaceDocument& d, const Array& vertices, const Faces& faces, int samples,
                   int threads) {
  const Surface surface = space(d);
  Mesh mesh;
  mesh.vertices = vector_of(vertices);
  mesh.faces.resize(static_cast<std::size_t>(faces.shape(0)));
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index c = 0; c < 3; ++c) mesh.faces[f][c] = faces.data()[3 * f + c];
  PointDistances to_surface;
  DistanceSummary to_mesh;
  const py::object raised = run({.threads = threads, .progress = py::none()}, [&](const Control& control) {
    if (!mesh.faces.empty()) inspect(mesh);
    to_surface = point_distances(surface, mesh.vertices, {}, {}, control);
    if (!mesh.faces.empty() && !to_surface.stopped)
      to_mesh = mesh_distances(surface, mesh, {}, samples, control);
  });
  return py::make_tuple(array_of(std::move(to_surface.signed_distances)), summary_of(to_surface.summary),
                        mesh.faces.empty() ? py::object(py::none()) : py::object(summary_of(to_mesh)),
                        raised);
}

}  // namespace

void bind_nearest(py::module_& m) {
  m.def("closest_points", &nearest, py::arg("document"), py::arg("points"), py::arg("threads"));
  m.def("distance", &distance, py::arg("document"), py::arg("vertices"), py::arg("faces"), py::arg("samples"),
        py::arg("threads"));
}

}  // namespace knotfit::python
