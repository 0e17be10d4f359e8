// Surfaces to faces.
#include <fmt/format.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>

#include "base/narrow.h"
#include "formats/cad/occt.h"
#include "knotfit/exceptions.h"
#include "spline/clamped.h"
namespace knotfit::cad {
namespace {

double diagonal_of(const Surface& s) {
  double squared = 0;
  for (int d = 0; d < 3; ++d) {
    double low = s.net()[static_cast<std::size_t>(d)], high = low;
    for (std::size_t k = static_cast<std::size_t>(d); k < s.net().size(); k += 3) {
      low = std::min(low, s.net()[k]);
      high = std::max(high, s.net()[k]);
    }
    squared += (high - low) * (high - low);
  }
  return std::sqrt(squared);
}

struct Breaks {
  explicit Breaks(const KnotVector& knots)
      : at(1, narrow(knots.span_count() + 1)), multiplicities(1, at.Upper()) {
    int k = 1;
    for (const double knot : knots.breaks()) {
      at(k) = knot;
      multiplicities(k++) = knots.multiplicity(knot);
    }
  }
  TColStd_Array1OfReal at;
  TColStd_Array1OfInteger multiplicities;
};

Handle(Geom_BSplineSurface) to_geometry(const Surface& s) {
  TColgp_Array2OfPnt points(1, narrow(s.size_u()), 1, narrow(s.size_v()));
  for (Index i = 0; i < s.size_u(); ++i)
    for (Index j = 0; j < s.size_v(); ++j) {
      const auto c = s.control_point(i, j);
      points(narrow(i + 1), narrow(j + 1)) = gp_Pnt(c[0], c[1], c[2]);
    }
  const Breaks u(s.knots_u()), v(s.knots_v());
  return new Geom_BSplineSurface(points, u.at, v.at, u.multiplicities, v.multiplicities, s.degree_u(),
                                 s.degree_v());
}

void check(const Surface& s, const std::string& which) {
  if (s.empty()) throw InvalidInput(which + " is empty");
  if (s.dimension() != 3)
    throw InvalidInput(
        fmt::format("{} has {} coordinates; CAD files hold surfaces of three (a height field as "
                    "height_field_in_space)",
                    which, s.dimension()));
  const auto jump = [&](const KnotVector& knots, char name) {
    for (const double knot : knots.interior())
      if (knots.multiplicity(knot) > knots.degree())
        throw InvalidInput(fmt::format("{} jumps at {} = {}, which no CAD face may; cad_safe splits it there",
                                       which, name, knot));
  };
  jump(s.knots_u(), 'u');
  jump(s.knots_v(), 'v');
  if (!(diagonal_of(s) > 0)) throw InvalidInput(which + " is a single point, of which no face can be made");
}

TopoDS_Face make_face(const Surface& surface, const std::string& which) {
  check(surface, which);
  const Surface s = clamped(surface);
  try {
    // An edge shorter than this is a point, where a side of the surface has collapsed.
    BRepBuilderAPI_MakeFace maker(to_geometry(s), std::min(Precision::Confusion(), 1e-9 * diagonal_of(s)));
    if (maker.IsDone()) return maker.Face();
  } catch (const Standard_Failure& failure) {
    throw InvalidInput(fmt::format("{} becomes no CAD face: {}", which, failure.GetMessageString()));
  }
  throw InvalidInput(which + " becomes no CAD face");
}

/// Faces that share edges where they meet, or an empty shape where sewing them is no use.
TopoDS_Shape sewn(const std::vector<TopoDS_Face>& faces) {
  try {
    BRepBuilderAPI_Sewing sewing(10 * Precision::Confusion());
    for (const TopoDS_Face& face : faces) sewing.Add(face);
    sewing.Perform();
    const TopoDS_Shape shape = sewing.SewedShape();
    Index count = 0;
    if (!shape.IsNull() && is_valid(shape, count) && count == static_cast<Index>(faces.size())) return shape;
  } catch (const Standard_Failure&) {
    // The faces stay apart.
  }
  return {};
}

}  // namespace

void build_shape(const std::vector<Surface>& surfaces, TopoDS_Shape& shape) {
  if (surfaces.empty()) throw InvalidInput("there is no surface to write");
  std::vector<TopoDS_Face> faces;
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    faces.push_back(make_face(
        surfaces[k], surfaces.size() == 1 ? std::string("the surface") : fmt::format("surface {}", k + 1)));
  for (std::size_t k = 0; k < faces.size(); ++k) {
    Index count = 0;
    if (!is_valid(faces[k], count))
      throw InvalidInput(fmt::format(
          "surface {} makes no valid CAD face: it folds onto itself at its border, or is as small as CAD's "
          "tolerance of {:g}; scale it, or choose a smaller unit",
          k + 1, Precision::Confusion()));
  }
  shape = faces.front();
  if (faces.size() == 1) return;
  shape = sewn(faces);
  if (!shape.IsNull()) return;
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Face& face : faces) builder.Add(compound, face);
  shape = compound;
}

bool is_valid(const TopoDS_Shape& shape, Index& faces) {
  faces = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) ++faces;
  return BRepCheck_Analyzer(shape).IsValid();
}

}  // namespace knotfit::cad
