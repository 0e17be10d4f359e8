#include "knotfit/cad.h"

#include <fmt/format.h>

#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "formats/cad/occt.h"
#include "formats/file_bytes.h"
#include "formats/write_file.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "spline/clamped.h"
namespace knotfit {
namespace {

using namespace cad;

/// Equal but for the last bits, which a unit's factor may cost.
bool same(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  if (a.size() != b.size()) return false;
  const double allowed = 4 * std::numeric_limits<double>::epsilon() * scale;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!(std::abs(a[k] - b[k]) <= allowed)) return false;
  return true;
}

bool same(const Surface& a, const Surface& b) {
  const auto knots = [](const KnotVector& s, const KnotVector& t) {
    return s.degree() == t.degree() &&
           same(s.knots(), t.knots(), std::max(std::abs(s.first()), std::abs(s.last())));
  };
  return knots(a.knots_u(), b.knots_u()) && knots(a.knots_v(), b.knots_v()) &&
         same(a.net(), b.net(), a.scale());
}

/// Reads `file` and compares. \throws WriteError  it is not what was to be written
void check_written(const std::string& file, const std::string& path, const std::vector<Surface>& surfaces,
                   const CadOptions& options) {
  const auto differs = [&](const std::string& what) {
    return WriteError(path, "read back with OpenCASCADE, the file differs: " + what + "; nothing was kept");
  };
  const FileBytes bytes = load_file(file);
  const FileKind kind = kind_of(bytes.view(), path);
  if (unit_of(bytes.view(), kind, path) != options.unit) throw differs("its unit is another");
  TopoDS_Shape shape;
  read_shape(file, kind, path, shape);
  Index faces = 0;
  if (!is_valid(shape, faces)) throw differs("a face is not valid");
  std::vector<Surface> read = surfaces_of(shape, path);
  if (faces != static_cast<Index>(surfaces.size()) || read.size() != surfaces.size())
    throw differs(fmt::format("{} faces, {} of them B-splines, where {} were written", faces, read.size(),
                              surfaces.size()));
  for (std::size_t k = 0; k < surfaces.size(); ++k) {  // sewn faces may come in another order
    const Surface wanted = clamped(surfaces[k]);
    const auto found =
        std::find_if(read.begin(), read.end(), [&](const Surface& s) { return same(s, wanted); });
    if (found == read.end()) throw differs(fmt::format("surface {} is not in it", k + 1));
    read.erase(found);
  }
}

}  // namespace

bool cad_available() {
  return true;
}

void write_cad(const std::string& path, const std::vector<Surface>& surfaces, const CadOptions& options,
               bool force) {
  check_writable(path, force);
  translating(path, [&] {
    Session session(options.unit);
    TopoDS_Shape shape;
    build_shape(surfaces, shape);
    const std::string text = file_text(shape, options, session);
    const auto write = [&](std::ostream& out) { out << text; };
    write_checked_file(path, force, write,
                       [&](const std::string& file) { check_written(file, path, surfaces, options); });
  });
}

std::vector<CadFace> read_cad_faces(const std::string& path, CadUnit unit) {
  std::vector<CadFace> faces;
  with_shape_of(path, unit, [&](const TopoDS_Shape& shape) { faces = faces_of(shape); });
  if (faces.empty()) throw FileError(path, "holds no B-spline surface: no face at all");
  return faces;
}

std::vector<Surface> read_cad(const std::string& path, CadUnit unit) {
  std::vector<Surface> surfaces;
  with_shape_of(path, unit, [&](const TopoDS_Shape& shape) { surfaces = surfaces_of(shape, path); });
  return surfaces;
}

}  // namespace knotfit
