// Files of surfaces and of data, as the tool reads and writes them.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bind.h"
#include "choices.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/picture.h"
#include "tool/applicable_options.h"
#include "tool/convert_surface.h"
#include "tool/input.h"
#include "tool/outputs.h"
#include "tool/surface_file.h"
#include "tool/text_values.h"
namespace knotfit::python {
namespace {

void save(const SurfaceDocument& d, const std::string& path, bool force, const Texts& texts) {
  const tool::Arguments arguments = take_texts(tool::Command::convert, texts);
  const std::vector<tool::OutputFile> files = tool::plan_outputs({.paths = {path}, .force = force}, "");
  tool::refuse_idle_output_options(arguments.choices.input.given, files);
  const py::gil_scoped_release released;
  tool::write_converted(files.front(), force, d, arguments, "");
}

py::bytes draw(const SurfaceDocument& d, const std::string& extension, int width, int height,
               bool reflections) {
  PictureInput picture;
  picture.surface = &d.surface;
  picture.reflections = reflections;
  std::string bytes;
  {
    const py::gil_scoped_release released;
    bytes = draw_picture(picture, extension, {.width = width, .height = height});
  }
  return py::bytes(bytes);
}

SurfaceDocument read_surface_file(const std::string& path, std::optional<int> face, const std::string& unit) {
  tool::SurfaceChoices choices;
  choices.face = face;
  if (!unit.empty()) choices.unit = tool::parse_named(tool::kUnits, unit);
  return tool::read_one_surface(path, choices);
}

/// ("raster", z, x0, y0, dx, dy), ("points", xyz, uv or None, weights or None), ("rows", xyz, starts),
/// ("mesh", vertices, faces, uv or None).
py::tuple read(const std::string& path) {
  SourceData data = read_data(path);
  if (auto* r = std::get_if<Raster>(&data.content))
    return py::make_tuple("raster", array_of(std::move(r->z), {r->rows, r->columns}), r->x0, r->y0, r->dx,
                          r->dy);
  if (auto* t = std::get_if<PointTable>(&data.content)) {
    const bool space = !t->x.empty();
    std::vector<double> values, uv;
    for (Index k = 0; k < t->size(); ++k) {
      if (space) values.insert(values.end(), {t->x[k], t->y[k]});
      values.push_back(t->z[k]);
      if (!t->u.empty()) uv.insert(uv.end(), {t->u[k], t->v[k]});
    }
    const Index n = t->size();
    return py::make_tuple(
        "points", array_of(std::move(values), {n, space ? 3 : 1}),
        uv.empty() ? py::object(py::none()) : py::object(array_of(std::move(uv), {n, 2})),
        t->weight.empty() ? py::object(py::none()) : py::object(array_of(std::move(t->weight))));
  }
  if (auto* rows = std::get_if<PointRows>(&data.content)) {
    const Index n = rows->size();
    return py::make_tuple("rows", array_of(std::move(rows->xyz), {n, 3}),
                          array_of(std::move(rows->row_start)));
  }
  Mesh& mesh = std::get<Mesh>(data.content);
  const Index n = mesh.vertex_count(), m = mesh.face_count();
  std::vector<std::int32_t> faces;
  for (const auto& face : mesh.faces) faces.insert(faces.end(), face.begin(), face.end());
  return py::make_tuple(
      "mesh", array_of(std::move(mesh.vertices), {n, 3}), array_of(std::move(faces), {m, 3}),
      mesh.uv.empty() ? py::object(py::none()) : py::object(array_of(std::move(mesh.uv), {n, 2})));
}

}  // namespace

void bind_files(py::module_& m) {
  m.def("save_surface", &save, py::arg("document"), py::arg("path"), py::arg("force"), py::arg("texts"));
  m.def("draw_surface", &draw, py::arg("document"), py::arg("extension"), py::arg("width"), py::arg("height"),
        py::arg("reflections"));
  m.def("read_surface", &read_surface_file, py::arg("path"), py::arg("face"), py::arg("unit"));
  m.def("read_data", &read, py::arg("path"), "A kind, and what a file of that kind holds.");
}

}  // namespace knotfit::python
