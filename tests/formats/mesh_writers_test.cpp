#include <algorithm>
#include <regex>

#include "knotfit/evaluate.h"
#include "knotfit/mesh_io.h"
#include "support.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// z = x y over [0,2] x [0,1], with a knot line along v.
Surface saddle() {
  const Surface height(KnotVector::uniform(2, 0), KnotVector::uniform(1, 1), 1,
                       {0, 0, 0, 0, 0.5, 1, 0, 1, 2});
  return height_field_in_space(height, 0, 2, 0, 1);
}

template <class T>
std::string written(void (*write)(std::ostream&, const T&), const T& what) {
  std::ostringstream out;
  write(out, what);
  return out.str();
}

TEST(Tessellation, TakesEveryKnotLineAndPointsOnTheSurface) {
  const Surface s = saddle();
  const Tessellation t = tessellate(s, 3);
  EXPECT_EQ(t.u, (std::vector<double>{0, 1.0 / 3, 2.0 / 3, 1}));
  ASSERT_EQ(t.v.size(), 7U);
  EXPECT_EQ(t.v[3], 0.5);
  EXPECT_EQ(t.size(), 28);
  for (std::size_t i = 0; i < t.u.size(); ++i)
    for (std::size_t j = 0; j < t.v.size(); ++j) {
      const std::size_t k = i * t.v.size() + j;
      const LocalGeometry g = local_geometry(s, t.u[i], t.v[j]);
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(t.points[3 * k + d], g.point[d], 1e-14);
        EXPECT_EQ(t.normals[3 * k + d], g.normal[d]);
      }
      EXPECT_EQ(t.mean_curvature[k], g.mean_curvature);
      EXPECT_EQ(t.gaussian_curvature[k], g.gaussian_curvature);
    }
}

TEST(Tessellation, RefusesWhatHasNoMesh) {
  const Surface height(KnotVector::uniform(1, 0), KnotVector::uniform(1, 0), 1, {0, 0, 0, 1});
  expect_throw<InvalidInput>([&] { tessellate(height); }, "dimension 1 has no mesh");
  expect_throw<InvalidInput>([&] { tessellate(saddle(), 0); }, "one or more");
  expect_throw<InvalidInput>([&] { tessellate(saddle(), 100000); }, "take fewer");
}

ParameterizedPoints points_at(const std::vector<double>& uv) {
  ParameterizedPoints p;
  p.dimension = 3;
  p.uv = uv;
  p.values.assign(uv.size() / 2 * 3, 0);
  return p;
}

TEST(Tessellation, ErrorsAreTheLargestNearEachPlace) {
  Tessellation t = tessellate(saddle(), 1);  // u 0 1, v 0 0.5 1
  add_errors(t, points_at({0.1, 0.1, 0.2, 0, 1, 1, 0.6, 0.7}), std::vector<double>{1, 3, 2, 5});
  expect_same(t.error, {3, kNan, kNan, kNan, 5, 2});
  expect_throw<InvalidInput>(
      [&] {
        add_errors(t, points_at({0, 0}), std::vector<double>{});
      },
      "0 errors for 1 points");
}

TEST(MeshWriters, ASurfaceReadsBackAsItWasWritten) {
  Tessellation t = tessellate(saddle(), 4);
  t.map = {.name_u = "x", .name_v = "y", .u0 = 0, .u1 = 2, .v0 = -1, .v1 = 1};
  add_errors(t, points_at({0.1, 0.1}), std::vector<double>{1});
  for (const auto& [name, bytes] : {std::pair{"a.obj", written<Tessellation>(write_obj, t)},
                                    std::pair{"a.ply", written<Tessellation>(write_ply, t)}}) {
    SCOPED_TRACE(name);
    const Mesh m = content<Mesh>(read(name, bytes));
    EXPECT_EQ(m.vertices, t.points);
    EXPECT_EQ(m.face_count(), static_cast<Index>(2 * (t.u.size() - 1) * (t.v.size() - 1)));
    EXPECT_TRUE(inspect(m).disk());
    ASSERT_EQ(m.uv.size(), 2 * t.points.size() / 3);
    for (std::size_t i = 0; i < t.u.size(); ++i)
      for (std::size_t j = 0; j < t.v.size(); ++j) {
        EXPECT_EQ(m.uv[2 * (i * t.v.size() + j)], t.map.from_u(t.u[i]));
        EXPECT_EQ(m.uv[2 * (i * t.v.size() + j) + 1], t.map.from_v(t.v[j]));
      }
    // Counter-clockwise against the surface's normal: z up here.
    for (const auto& c : m.faces) {
      const double *p = m.vertex(c[0]), *q = m.vertex(c[1]), *r = m.vertex(c[2]);
      EXPECT_GT((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), 0);
    }
  }
}

std::vector<double> decoded(const std::string& file, const std::string& name) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = file.find("Name=\"" + name + "\""), begin = file.find('>', at) + 1,
                    end = file.find('<', begin);
  EXPECT_NE(at, std::string::npos);
  std::string bytes;
  for (std::size_t k = begin; k < end; k += 4) {
    unsigned group = 0;
    int pads = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t digit = digits.find(file[k + i]);
      pads += file[k + i] == '=';
      group = group << 6 | (digit == std::string::npos ? 0U : static_cast<unsigned>(digit));
    }
    for (int i = 0; i < 3 - pads; ++i) bytes += static_cast<char>(group >> (16 - 8 * i) & 255);
  }
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), 8);
  EXPECT_EQ(size, bytes.size() - 8);
  std::vector<double> out((bytes.size() - 8) / 8);
  std::memcpy(out.data(), bytes.data() + 8, 8 * out.size());
  return out;
}

TEST(MeshWriters, VtkArraysRunAlongUFirst) {
  Tessellation t = tessellate(saddle(), 2);
  add_errors(t, points_at({0.1, 0.1, 0.9, 0.8}), std::vector<double>{1, 4});
  const std::string file = written<Tessellation>(write_vts, t);
  EXPECT_NE(file.find("WholeExtent=\"0 2 0 4 0 0\""), std::string::npos);
  const std::vector<double> points = decoded(file, "points"), error = decoded(file, "error"),
                            uv = decoded(file, "uv"), normal = decoded(file, "normal"),
                            mean = decoded(file, "mean_curvature"),
                            gauss = decoded(file, "gaussian_curvature");
  const std::size_t nu = t.u.size(), nv = t.v.size();
  ASSERT_EQ(points.size(), 3 * nu * nv);
  ASSERT_EQ(error.size(), nu * nv);
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t j = 0; j < nv; ++j) {
      const std::size_t there = j * nu + i, here = i * nv + j;
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_EQ(points[3 * there + d], t.points[3 * here + d]);
        EXPECT_EQ(normal[3 * there + d], t.normals[3 * here + d]);
      }
      EXPECT_TRUE(error[there] == t.error[here] || (std::isnan(error[there]) && std::isnan(t.error[here])));
      EXPECT_EQ(mean[there], t.mean_curvature[here]);
      EXPECT_EQ(gauss[there], t.gaussian_curvature[here]);
      EXPECT_EQ(uv[2 * there], t.u[i]);
      EXPECT_EQ(uv[2 * there + 1], t.v[j]);
    }
  t.error.clear();
  EXPECT_EQ(written<Tessellation>(write_vts, t).find("error"), std::string::npos);
}

Mesh two_triangles() {
  Mesh m;
  m.vertices = {0, 0, 0, 1, 0, 0, 1, 1, 1.0 / 3, 0, 1, 0};
  m.faces = {{0, 1, 2}, {0, 2, 3}};
  m.uv = {0, 0, 1, 0, 1, 1, 0.1, 1};
  return m;
}

TEST(MeshWriters, AMeshReadsBackWithItsParameters) {
  for (const bool with_uv : {true, false}) {
    Mesh m = two_triangles();
    if (!with_uv) m.uv.clear();
    for (const auto& [name, bytes] :
         {std::pair{"a.obj", written<Mesh>(write_obj, m)}, std::pair{"a.ply", written<Mesh>(write_ply, m)}}) {
      const Mesh back = content<Mesh>(read(name, bytes));
      EXPECT_EQ(back.vertices, m.vertices) << name;
      EXPECT_EQ(back.faces, m.faces) << name;
      EXPECT_EQ(back.uv, m.uv) << name;
    }
  }
  Mesh m = two_triangles();
  m.uv.pop_back();
  m.uv.pop_back();
  expect_throw<InvalidInput>([&] { written<Mesh>(write_obj, m); }, "3 parameters for 4 vertices");
}

TEST(MeshWriters, VirtualFacesAreLeftOut) {
  Mesh m = two_triangles();
  m.vertices.insert(m.vertices.begin(), {5, 5, 5});
  m.uv.insert(m.uv.begin(), {0.5, 0.5});
  for (auto& c : m.faces)
    for (auto& v : c) ++v;
  m.faces.insert(m.faces.begin(), {0, 1, 2});
  m.virtual_face = {1, 0, 0};
  const Mesh back = content<Mesh>(read("a.obj", written<Mesh>(write_obj, m)));
  EXPECT_EQ(back.vertices, two_triangles().vertices);
  EXPECT_EQ(back.faces, two_triangles().faces);
  EXPECT_EQ(back.uv, two_triangles().uv);
}

}  // namespace
}  // namespace knotfit::test
