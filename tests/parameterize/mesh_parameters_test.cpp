#include "knotfit/mesh_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "data/meshes.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
namespace knotfit::test {
namespace {

using Map = std::function<std::array<double, 2>(double, double)>;

/// A sheet of 8 x 6 cells with parameters of its (x, y).
Mesh with(const Map& map) {
  Mesh mesh = sheet(8, 6);
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    const auto [u, v] = map(mesh.vertex(k)[0], mesh.vertex(k)[1]);
    mesh.uv.insert(mesh.uv.end(), {u, v});
  }
  return mesh;
}

void expect_why(const Mesh& mesh, const std::string& words) {
  const ParameterCheck check = check_parameters(mesh);
  EXPECT_FALSE(check.one_to_one);
  EXPECT_NE(check.why.find(words), std::string::npos) << check.why;
}

TEST(MeshParameters, ThatAreOneToOne) {
  const Map maps[] = {[](double x, double y) {
                        return std::array{x, y};
                      },
                      [](double x, double y) {
                        return std::array{x, 1 - y};
                      },  // all turned over: images count from the top
                      [](double x, double y) {
                        return std::array{7 + 3 * x + y, 1e-4 * y};
                      },
                      [](double x, double y) {
                        return std::array{x * x + x, std::exp(y) + 0.2 * x};
                      },
                      // Rounded to six digits.
                      [](double x, double y) {
                        return std::array{std::round(1e6 * x) / 1e6, std::round(1e6 * y) / 1e6};
                      },
                      // Three quarters of a ring.
                      [](double x, double y) {
                        return std::array{(1 + y) * std::cos(4.7 * x), (1 + y) * std::sin(4.7 * x)};
                      }};
  for (const Map& map : maps) {
    const ParameterCheck check = check_parameters(with(map));
    EXPECT_TRUE(check.one_to_one) << check.why;
    EXPECT_EQ(check.why, "");
  }
}

TEST(MeshParameters, EqualAtAllVerticesOrOnALine) {
  expect_why(with([](double, double) {
               return std::array{0.5, 0.25};
             }),
             "equal at all vertices, u = 0.5 and v = 0.25");
  expect_why(with([](double, double y) { return std::array{0.5, y}; }), "on a line, u = 0.5 at all vertices");
  expect_why(with([](double x, double) { return std::array{x, 3.0}; }), "on a line, v = 3 at all vertices");
  expect_why(with([](double x, double y) { return std::array{x + y, 2 - x - y}; }), "they lie on a line");
}

TEST(MeshParameters, Mirrored) {
  expect_why(with([](double x, double y) {
               return std::array{std::abs(x - 0.5), y};
             }),
             "48 of 96 triangles are mirrored");
  Mesh mesh = with([](double x, double y) { return std::array{x, y}; });
  std::swap(mesh.uv[2 * 30], mesh.uv[2 * 31]);  // two neighbours
  expect_why(mesh, "triangles are mirrored");
}

TEST(MeshParameters, ThatCoverThemselves) {
  // A ring that goes round once and a quarter.
  expect_why(with([](double x, double y) {
               return std::array{(1 + y) * std::cos(7.8 * x), (1 + y) * std::sin(7.8 * x)};
             }),
             "cover each other");
  // Two charts on the same square.
  Mesh mesh = with([](double x, double y) { return std::array{x, y}; });
  Mesh twice = mesh;
  append(twice, mesh, 3);
  for (const double t : mesh.uv) twice.uv.push_back(0.97 * t + 0.01);
  expect_why(twice, "cover each other");
  twice.counted_from = 1;
  for (std::size_t k = mesh.uv.size(); k < twice.uv.size(); k += 2) twice.uv[k] += 1;
  EXPECT_TRUE(check_parameters(twice).one_to_one) << "side by side";
}

TEST(MeshParameters, OfSeveralVerticesAtOnePlace) {
  Mesh mesh = with([](double x, double y) { return std::array{x, y}; });
  Mesh twice = mesh;
  append(twice, mesh, 3);
  twice.uv.insert(twice.uv.end(), mesh.uv.begin(), mesh.uv.end());
  twice.counted_from = 1;
  expect_why(twice, "63 vertices have those of another vertex elsewhere, such as 1 and 64 (counted from 1)");
  // At the same place too: nothing contradicts.
  Mesh copy = mesh;
  copy.vertices.insert(copy.vertices.end(), mesh.vertex(5), mesh.vertex(5) + 3);
  copy.uv.insert(copy.uv.end(), {mesh.uv[10], mesh.uv[11]});
  copy.faces[0] = copy.faces[0];
  EXPECT_TRUE(check_parameters(copy).one_to_one);
}

TEST(MeshParameters, Missing) {
  Mesh mesh = with([](double x, double y) { return std::array{x, y}; });
  mesh.uv[7] = std::nan("");
  expect_why(mesh, "1 of the vertices has none that is finite");
  // Of a vertex that no face uses, nothing is asked.
  mesh.uv[7] = mesh.vertex(3)[1];
  mesh.vertices.insert(mesh.vertices.end(), {9, 9, 9});
  mesh.uv.insert(mesh.uv.end(), {std::nan(""), 5});
  EXPECT_TRUE(check_parameters(mesh).one_to_one);
}

TEST(MeshParameters, FlatTrianglesOfSomeArea) {
  expect_why(with([](double x, double y) {
               return std::array{std::max(0.25, x), y};
             }),
             "24 of 96 triangles have no area in them");
  expect_why(with([](double x, double y) {
               return std::array{x < 0.25 ? 0.25 + 1e-9 * x : x, y};
             }),
             "24 of 96 triangles have no area in them");
}

TEST(MeshParameters, VirtualFacesDoNotCount) {
  Mesh mesh = with([](double x, double y) { return std::array{x, y}; });
  mesh.virtual_face.assign(mesh.faces.size(), 0);
  mesh.faces.push_back({0, 40, 60});
  mesh.virtual_face.push_back(1);
  EXPECT_TRUE(check_parameters(mesh).one_to_one);
  mesh.virtual_face.back() = 0;
  EXPECT_FALSE(check_parameters(mesh).one_to_one);
}

TEST(MeshParameters, OfManySliversAreChecked) {
  // 40 000 triangles of 1 : 10 000 in the plane.
  Mesh mesh = sheet(20000, 1);
  for (Index k = 0; k < mesh.vertex_count(); ++k)
    mesh.uv.insert(mesh.uv.end(), {mesh.vertex(k)[0], mesh.vertex(k)[1]});
  EXPECT_TRUE(check_parameters(mesh).one_to_one);
  for (Index k = 0; k < mesh.vertex_count(); ++k) mesh.uv[2 * k] = std::fmod(1.5 * mesh.uv[2 * k], 1.0);
  EXPECT_FALSE(check_parameters(mesh).one_to_one);
}

TEST(MeshParameters, MustBeTwoAVertex) {
  Mesh mesh = sheet(2, 2);
  expect_throw<InvalidInput>([&] { check_parameters(mesh); }, "0 parameters for 9 vertices");
}

}  // namespace
}  // namespace knotfit::test
