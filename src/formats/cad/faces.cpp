// Faces to surfaces: what each is, and whether knotfit can represent it.
#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "formats/cad/occt.h"
#include "knotfit/exceptions.h"
namespace knotfit::cad {
namespace {

std::vector<double> flat_knots(const TColStd_Array1OfReal& sequence) {
  std::vector<double> knots;
  for (int k = sequence.Lower(); k <= sequence.Upper(); ++k) knots.push_back(sequence(k));
  return knots;
}

Surface from_geometry(const Geom_BSplineSurface& g) {
  const int n = g.NbUPoles(), m = g.NbVPoles(), p = g.UDegree(), q = g.VDegree();
  TColStd_Array1OfReal u(1, n + p + 1), v(1, m + q + 1);
  g.UKnotSequence(u);
  g.VKnotSequence(v);
  std::vector<double> net;
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) {
      const gp_Pnt c = g.Pole(i, j);
      net.insert(net.end(), {c.X(), c.Y(), c.Z()});
    }
  return Surface(KnotVector(p, flat_knots(u)), KnotVector(q, flat_knots(v)), 3, std::move(net));
}

/// The face's surface as a B-spline of its own, or null where it is none.
Handle(Geom_BSplineSurface) spline_of(const TopoDS_Face& face) {
  Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);  // moved to where the face lies
  if (geometry.IsNull()) return {};
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(geometry); !trimmed.IsNull()) {
    const Handle(Geom_Surface) basis = trimmed->BasisSurface();
    if (!basis->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) &&
        !basis->IsKind(STANDARD_TYPE(Geom_BezierSurface)))
      return {};
    return GeomConvert::SurfaceToBSplineSurface(trimmed);
  }
  if (geometry->IsKind(STANDARD_TYPE(Geom_BezierSurface)))
    return GeomConvert::SurfaceToBSplineSurface(geometry);
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry);
  if (spline.IsNull()) return {};
  auto copy = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
  if (copy->IsUPeriodic()) copy->SetUNotPeriodic();
  if (copy->IsVPeriodic()) copy->SetVNotPeriodic();
  return copy;
}

/// "plane" from Geom_Plane, for messages.
std::string kind_name(const Handle(Geom_Surface) & geometry) {
  std::string name = geometry.IsNull() ? "surface of no kind" : geometry->DynamicType()->Name();
  if (name.starts_with("Geom_")) name.erase(0, 5);
  std::string text;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z' && !text.empty()) text += ' ';
    text += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return text;
}

/// The face covers less than its surface: an edge runs inside, or a side of the domain has none along it.
bool is_trimmed(const TopoDS_Face& face, const Geom_BSplineSurface& surface) {
  constexpr int kSamples = 8;
  constexpr double kNear = 1e-6;  // of the domain
  double low[2], high[2];
  surface.Bounds(low[0], high[0], low[1], high[1]);
  Index edges = 0;
  bool reached[2][2] = {};  // the low and high side of u and of v
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), face, first, last);
    if (curve.IsNull()) continue;
    ++edges;
    for (int k = 0; k <= kSamples; ++k) {
      const gp_Pnt2d p = curve->Value(first + (last - first) * k / kSamples);
      const double at[2] = {p.X(), p.Y()};
      bool on_border = false;
      for (int d = 0; d < 2; ++d) {
        const double near = kNear * (high[d] - low[d]);
        reached[d][0] = reached[d][0] || at[d] <= low[d] + near;
        reached[d][1] = reached[d][1] || at[d] >= high[d] - near;
        on_border = on_border || at[d] <= low[d] + near || at[d] >= high[d] - near;
      }
      if (!on_border) return true;
    }
  }
  return edges > 0 && !(reached[0][0] && reached[0][1] && reached[1][0] && reached[1][1]);
}

CadFace face_of(const TopoDS_Face& face) {
  CadFace out;
  out.kind = kind_name(BRep_Tool::Surface(face));
  const Handle(Geom_BSplineSurface) spline = spline_of(face);
  if (spline.IsNull()) {
    out.why = "it is no B-spline surface";
    return out;
  }
  const bool rational = spline->IsURational() || spline->IsVRational();
  out.kind = rational ? "rational B-spline surface" : "B-spline surface";
  out.trimmed = is_trimmed(face, *spline);
  if (rational) {
    out.why = "it is rational (NURBS with weights that differ), which knotfit does not represent";
  } else if (std::max(spline->UDegree(), spline->VDegree()) > kMaxDegree) {
    out.why = fmt::format("it has degree {} x {}; the highest is {}", spline->UDegree(), spline->VDegree(),
                          kMaxDegree);
  } else {
    try {
      out.surface = from_geometry(*spline);
    } catch (const InvalidInput& error) {
      out.why = error.what();
    }
  }
  return out;
}

}  // namespace

std::vector<CadFace> faces_of(const TopoDS_Shape& shape) {
  std::vector<CadFace> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    try {
      faces.push_back(face_of(TopoDS::Face(face.Current())));
    } catch (const Standard_Failure& failure) {
      faces.push_back({.kind = "surface",
                       .surface = {},
                       .why = fmt::format("OpenCASCADE gave up: {} {}", failure.DynamicType()->Name(),
                                          failure.GetMessageString())});
    }
  }
  return faces;
}

std::vector<Surface> usable_surfaces(const std::vector<CadFace>& faces, const std::string& path) {
  std::vector<Surface> surfaces;
  std::map<std::string, int> others;
  std::string reasons;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const CadFace& face = faces[k];
    if (face.surface) {
      surfaces.push_back(*face.surface);
    } else {
      ++others[face.kind];
      if (face.kind.ends_with("B-spline surface") && reasons.size() < 300)
        reasons += fmt::format("; face {}: {}", k + 1, face.why);
    }
  }
  if (!surfaces.empty()) return surfaces;
  std::string found;
  for (const auto& [kind, count] : others)
    found += fmt::format("{}{} {}", found.empty() ? "" : ", ", count, kind);
  throw FileError(path, "holds no B-spline surface that can be used" +
                            (found.empty() ? "" : "; its faces are: " + found) + reasons);
}

std::vector<Surface> surfaces_of(const TopoDS_Shape& shape, const std::string& path) {
  return usable_surfaces(faces_of(shape), path);
}

}  // namespace knotfit::cad
