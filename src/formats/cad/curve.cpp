// Curves to edges and back.
#include <fmt/format.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "base/narrow.h"
#include "formats/cad/occt.h"
#include "formats/file_bytes.h"
#include "formats/write_file.h"
#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
namespace knotfit {
namespace {

using namespace cad;

TopoDS_Edge make_edge(const Curve& c) {
  if (c.dimension() != 3)
    throw InvalidInput(
        fmt::format("the curve has {} coordinates; CAD files hold curves of three", c.dimension()));
  if (!c.knots().is_clamped()) throw InvalidInput("the curve's ends are no knots of full multiplicity");
  const std::vector<double> breaks = c.knots().breaks();
  TColStd_Array1OfReal at(1, narrow(breaks.size()));
  TColStd_Array1OfInteger multiplicities(1, at.Upper());
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const int multiplicity = c.knots().multiplicity(breaks[k]);
    if (k > 0 && k + 1 < breaks.size() && multiplicity > c.degree())
      throw InvalidInput(fmt::format("the curve jumps at t = {}, which no CAD edge may", breaks[k]));
    at(narrow(k + 1)) = breaks[k];
    multiplicities(narrow(k + 1)) = multiplicity;
  }
  TColgp_Array1OfPnt points(1, narrow(c.size()));
  for (Index i = 0; i < c.size(); ++i) {
    const double* p = c.control_points().data() + 3 * i;
    points(narrow(i + 1)) = gp_Pnt(p[0], p[1], p[2]);
  }
  try {
    BRepBuilderAPI_MakeEdge maker(new Geom_BSplineCurve(points, at, multiplicities, c.degree()));
    if (maker.IsDone()) return maker.Edge();
  } catch (const Standard_Failure& failure) {
    throw InvalidInput(fmt::format("the curve becomes no CAD edge: {}", failure.GetMessageString()));
  }
  throw InvalidInput(fmt::format("the curve becomes no CAD edge: is it shorter than CAD's tolerance of {:g}?",
                                 Precision::Confusion()));
}

std::vector<Curve> curves_of(const TopoDS_Shape& shape, const std::string& path) {
  std::vector<Curve> curves;
  std::string unusable;  // why the first that is so is not usable: others may be
  const auto leave_out = [&](const std::string& why) {
    if (unusable.empty()) unusable = why;
  };
  for (TopExp_Explorer edge(shape, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) {
    double first = 0, last = 0;
    Handle(Geom_Curve) geometry = BRep_Tool::Curve(TopoDS::Edge(edge.Current()), first, last);
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(geometry); !trimmed.IsNull())
      geometry = trimmed->BasisCurve();
    const auto found = Handle(Geom_BSplineCurve)::DownCast(geometry);
    if (found.IsNull()) continue;
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(found->Copy());
    if (spline->IsRational()) {
      leave_out("a curve is rational (NURBS with weights that differ), which knotfit does not represent");
      continue;
    }
    if (spline->Degree() > kMaxDegree) {
      leave_out(fmt::format("a curve has degree {}; the highest is {}", spline->Degree(), kMaxDegree));
      continue;
    }
    if (spline->IsPeriodic()) spline->SetNotPeriodic();
    TColStd_Array1OfReal sequence(1, spline->NbPoles() + spline->Degree() + 1);
    spline->KnotSequence(sequence);
    std::vector<double> knots(sequence.begin(), sequence.end()), net;
    for (int i = 1; i <= spline->NbPoles(); ++i) {
      const gp_Pnt p = spline->Pole(i);
      net.insert(net.end(), {p.X(), p.Y(), p.Z()});
    }
    try {
      curves.emplace_back(KnotVector(spline->Degree(), std::move(knots)), 3, std::move(net));
    } catch (const InvalidInput& error) {
      leave_out(error.what());
    }
  }
  if (curves.empty() && !unusable.empty()) throw FileError(path, unusable);
  if (curves.empty()) throw FileError(path, "holds no B-spline curve that belongs to no face");
  return curves;
}

/// The same curve: OpenCASCADE reads one whose ends meet smoothly as periodic, whose knots at the seam are its own.
bool same(const Curve& a, const Curve& b) {
  if (a.degree() != b.degree() || a.dimension() != b.dimension()) return false;
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const std::vector<double> breaks = b.knots().breaks(), others = a.knots().breaks();
  if (others.size() != breaks.size()) return false;
  double scale = 0;
  for (double x : b.control_points()) scale = std::max(scale, std::abs(x));
  std::vector<double> t;
  for (std::size_t s = 0; s < breaks.size(); ++s) {
    if (!(std::abs(others[s] - breaks[s]) <= 4 * kEps)) return false;
    // As many places a span as fix its polynomial.
    for (int k = 0; s > 0 && k <= b.degree(); ++k)
      t.push_back(breaks[s - 1] + (breaks[s] - breaks[s - 1]) * (k + 0.5) / (b.degree() + 1));
  }
  const std::vector<double> p = evaluate(a, t), q = evaluate(b, t);
  for (std::size_t k = 0; k < p.size(); ++k)
    if (!(std::abs(p[k] - q[k]) <= 64 * kEps * scale)) return false;
  return true;
}

}  // namespace

void write_cad_curve(const std::string& path, const Curve& curve, const CadOptions& options, bool force) {
  check_writable(path, force);
  translating(path, [&] {
    Session session(options.unit);
    const TopoDS_Shape shape = make_edge(curve);
    const std::string text = file_text(shape, options, session);
    const auto check = [&](const std::string& file) {
      const FileBytes bytes = load_file(file);
      const FileKind kind = kind_of(bytes.view(), path);
      TopoDS_Shape read;
      read_shape(file, kind, path, read);
      const std::vector<Curve> curves = curves_of(read, path);
      if (unit_of(bytes.view(), kind, path) != options.unit || curves.size() != 1 || !same(curves[0], curve))
        throw WriteError(path, "read back with OpenCASCADE, the curve differs; nothing was kept");
    };
    write_checked_file(
        path, force, [&](std::ostream& out) { out << text; }, check);
  });
}

std::vector<Curve> read_cad_curves(const std::string& path, CadUnit unit) {
  std::vector<Curve> curves;
  with_shape_of(path, unit, [&](const TopoDS_Shape& shape) { curves = curves_of(shape, path); });
  return curves;
}

}  // namespace knotfit
