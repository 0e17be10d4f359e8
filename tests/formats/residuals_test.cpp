#include "support.h"
namespace knotfit::test {
namespace {

std::string residuals(const ParameterizedPoints& p, const std::vector<double>& errors) {
  std::ostringstream out;
  write_residuals(out, p, errors);
  return out.str();
}

TEST(Residuals, GeometryInTheUsersParameters) {
  ParameterizedPoints p;
  p.dimension = 3;
  p.uv = {0, 0.5, 1, 0.25};
  p.values = {1, 2, 3, 4, 5, 6.5};
  EXPECT_EQ(residuals(p, {0.125, 0}), "x,y,z,u,v,error\n1,2,3,0,0.5,0.125\n4,5,6.5,1,0.25,0\n");
  p.map.u0 = 10;
  p.map.u1 = 20;
  EXPECT_EQ(residuals(p, {0.125, 0}), "x,y,z,u,v,error\n1,2,3,10,0.5,0.125\n4,5,6.5,20,0.25,0\n");
}

TEST(Residuals, HeightFieldsGetTheirPlaceAndTheSurfacesParameters) {
  ParameterizedPoints p;
  p.height_field = true;
  p.map = {"x", "y", 100, 200, -1, 1};
  p.uv = {0.5, 0.25};
  p.values = {7};
  EXPECT_EQ(residuals(p, {1e-9}), "x,y,z,u,v,error\n150,-0.5,7,0.5,0.25,1e-09\n");
  p.height_field = false;
  EXPECT_EQ(residuals(p, {1e-9}), "z,u,v,error\n7,150,-0.5,1e-09\n");
}

TEST(Residuals, OtherDimensions) {
  ParameterizedPoints p;
  p.uv = {0, 1};
  p.dimension = 2;
  p.values = {1, 2};
  EXPECT_EQ(residuals(p, {0}), "x,y,u,v,error\n1,2,0,1,0\n");
  p.dimension = 5;
  p.values = {1, 2, 3, 4, 5};
  EXPECT_EQ(residuals(p, {0}), "x,y,z,a4,a5,u,v,error\n1,2,3,4,5,0,1,0\n");
}

TEST(Residuals, ReadBackAsPoints) {
  ParameterizedPoints p;
  p.dimension = 3;
  std::vector<double> errors;
  for (int k = 0; k < 5000; ++k) {
    p.uv.insert(p.uv.end(), {k / 5000.0, 1 / (k + 1.0)});
    p.values.insert(p.values.end(), {std::sin(k), std::cos(k), 1e-7 * k});
    errors.push_back(1e-3 / (k + 3));
  }
  const PointTable t = table(residuals(p, errors));
  ASSERT_EQ(t.size(), 5000);
  for (std::size_t k = 0; k < 5000; ++k) {
    EXPECT_EQ(t.x[k], p.values[3 * k]);
    EXPECT_EQ(t.z[k], p.values[3 * k + 2]);
    EXPECT_EQ(t.v[k], p.uv[2 * k + 1]);
  }
}

TEST(Residuals, AnErrorAPointIsNeeded) {
  ParameterizedPoints p;
  p.uv = {0, 1};
  p.values = {1};
  expect_throw<InvalidInput>([&] { residuals(p, {}); }, "0 errors and 1 values of dimension 1 for 1 points");
}

}  // namespace
}  // namespace knotfit::test
