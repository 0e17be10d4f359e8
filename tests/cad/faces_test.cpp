// Faces made by OpenCASCADE itself: what is said of each.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

#include "formats/cad/occt.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

/// Bilinear over [0,1]^2, `weight` of one corner.
Handle(Geom_BSplineSurface) patch(double weight, int degree = 1) {
  TColgp_Array2OfPnt poles(1, degree + 1, 1, 2);
  TColStd_Array2OfReal weights(1, degree + 1, 1, 2);
  for (int i = 1; i <= degree + 1; ++i)
    for (int j = 1; j <= 2; ++j) {
      poles(i, j) = gp_Pnt(4.0 * (i - 1) / degree, 3.0 * (j - 1), i == 1 && j == 1 ? 0.5 : 0);
      weights(i, j) = i == 1 && j == 1 ? weight : 1;
    }
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0, knots(2) = 1;
  TColStd_Array1OfInteger along(1, 2), across(1, 2);
  along.Init(degree + 1);
  across.Init(2);
  return new Geom_BSplineSurface(poles, weights, knots, knots, along, across, degree, 1);
}

TopoDS_Face whole(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Face with_round_hole(const Handle(Geom_BSplineSurface) & surface) {
  const Handle(Geom2d_Circle) circle = new Geom2d_Circle(gp_Ax22d(gp_Pnt2d(0.5, 0.5), gp_Dir2d(1, 0)), 0.2);
  BRepBuilderAPI_MakeEdge edge(circle, surface);
  BRepBuilderAPI_MakeFace maker(whole(surface), BRepBuilderAPI_MakeWire(edge.Edge()).Wire());
  BRepLib::BuildCurves3d(maker.Face());
  return maker.Face();
}

TEST(CadFaces, EachIsToldByKindAndUse) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, whole(patch(2)));
  builder.Add(all, whole(patch(1)));
  builder.Add(all, BRepBuilderAPI_MakeFace(patch(1), 0.0, 0.5, 0.0, 1.0, 1e-7).Face());
  builder.Add(all, with_round_hole(patch(1)));
  builder.Add(all, BRepBuilderAPI_MakeFace(new Geom_Plane(gp::XOY()), 0.0, 1.0, 0.0, 1.0, 1e-7).Face());
  builder.Add(
      all,
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp::XOY(), 1), 0.0, 1.0, 0.0, 1.0, 1e-7).Face());
  builder.Add(all, whole(patch(1, 11)));
  const std::vector<CadFace> faces = cad::faces_of(all);
  struct Wanted {
    const char* kind;
    bool usable, trimmed;
    const char* why;
  };
  const Wanted wanted[] = {{"rational B-spline surface", false, false, "weights that differ"},
                           {"B-spline surface", true, false, ""},
                           {"B-spline surface", true, true, ""},
                           {"B-spline surface", true, true, ""},
                           {"plane", false, false, "no B-spline surface"},
                           {"cylindrical surface", false, false, "no B-spline surface"},
                           {"B-spline surface", false, false, "degree 11 x 1; the highest is 9"}};
  ASSERT_EQ(faces.size(), std::size(wanted));
  for (std::size_t k = 0; k < faces.size(); ++k) {
    SCOPED_TRACE(k);
    EXPECT_EQ(faces[k].kind, wanted[k].kind);
    EXPECT_EQ(faces[k].surface.has_value(), wanted[k].usable);
    EXPECT_EQ(faces[k].trimmed, wanted[k].trimmed);
    EXPECT_NE(faces[k].why.find(wanted[k].why), std::string::npos) << faces[k].why;
    EXPECT_EQ(faces[k].why.empty(), wanted[k].usable);
  }
  // Trimmed faces give their whole surface.
  EXPECT_EQ(*faces[2].surface, *faces[1].surface);
  EXPECT_EQ(faces[1].surface->net(), (std::vector<double>{0, 0, 0.5, 0, 3, 0, 4, 0, 0, 4, 3, 0}));
  EXPECT_EQ(cad::usable_surfaces(faces, "a.step").size(), 3U);
  expect_throw<FileError>(
      [&] {
        cad::usable_surfaces({faces[0], faces[4], faces[5]}, "a.step");
      },
      "a.step: holds no B-spline surface that can be used; its faces are: 1 cylindrical surface, 1 plane, "
      "1 rational B-spline surface; face 1: it is rational");
}

}  // namespace
}  // namespace knotfit::test
