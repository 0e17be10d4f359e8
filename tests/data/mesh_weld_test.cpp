#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "knotfit/exceptions.h"
#include "knotfit/weld_mesh.h"
#include "meshes.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

/// The mesh with corners of its own for each face.
Mesh soup(const Mesh& mesh) {
  Mesh out;
  for (const auto& c : mesh.faces) {
    const auto first = static_cast<std::int32_t>(out.vertex_count());
    for (const std::int32_t v : c) {
      out.vertices.insert(out.vertices.end(), mesh.vertex(v), mesh.vertex(v) + 3);
      if (!mesh.uv.empty()) out.uv.insert(out.uv.end(), {mesh.uv[2 * v], mesh.uv[2 * v + 1]});
    }
    out.faces.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// Corner by corner at the same places.
void expect_same_faces(const Mesh& a, const Mesh& b, double within = 0) {
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t f = 0; f < a.faces.size(); ++f)
    for (int k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d) EXPECT_NEAR(a.vertex(a.faces[f][k])[d], b.vertex(b.faces[f][k])[d], within);
}

void cut_edges(Mesh& mesh, const std::vector<std::int32_t>& vertices, const std::vector<Index>& faces,
               double shift) {
  for (const std::int32_t v : vertices) {
    const auto copy = static_cast<std::int32_t>(mesh.vertex_count());
    for (int d = 0; d < 3; ++d) mesh.vertices.push_back(mesh.vertices[3 * v + d] + (d == 2 ? shift : 0));
    for (const Index f : faces) std::replace(mesh.faces[f].begin(), mesh.faces[f].end(), v, copy);
  }
}

TEST(Weld, MakesASoupTheMeshItCameFrom) {
  const Mesh whole = sheet(7, 5);
  Mesh mesh = soup(whole);
  for (Index k = 0; k < mesh.vertex_count(); ++k) mesh.vertex_line.push_back(k + 10);
  EXPECT_EQ(inspect(mesh).parts, 70);
  const Mesh before = mesh;
  const WeldSummary summary = weld(mesh, weld_tolerance(mesh));
  EXPECT_EQ(summary.vertices, 210 - 48);
  EXPECT_EQ(summary.parts_before, 70);
  EXPECT_EQ(summary.parts_after, 1);
  EXPECT_EQ(summary.distance, 0);
  EXPECT_EQ(summary.left_apart, 0);
  EXPECT_EQ(mesh.vertex_count(), 48);
  EXPECT_TRUE(inspect(mesh).disk());
  EXPECT_EQ(inspect(mesh).loop_edges, inspect(whole).loop_edges);
  expect_same_faces(mesh, whole);
  // Vertices keep their number and line in the file: of those at one place the first.
  for (Index k = 0; k < 48; ++k) {
    EXPECT_EQ(mesh.vertex_line[k], mesh.vertex_source[k] + 10);
    for (int d = 0; d < 3; ++d) EXPECT_EQ(mesh.vertex(k)[d], before.vertex(mesh.vertex_source[k])[d]);
  }
}

TEST(Weld, AMeshThatIsJoinedStaysAsItIs) {
  for (const Mesh& whole : {sheet(4, 3), band(6, false), band(7, true), torus(5, 6)}) {
    Mesh mesh = whole;
    EXPECT_EQ(weld(mesh, weld_tolerance(mesh)).vertices, 0);
    EXPECT_EQ(mesh.vertices, whole.vertices);
    EXPECT_EQ(mesh.faces, whole.faces);
    EXPECT_TRUE(mesh.vertex_source.empty());
  }
}

TEST(Weld, CopiesThatDifferInTheLastBitOfSinglePrecision) {
  // Near the origin, and far from it, where a last bit is more than 1e-7 of the diagonal.
  for (const double offset : {0.0, 100.0}) {
    Mesh whole = sheet(6, 6);
    for (double& x : whole.vertices) x = static_cast<float>(x + offset);
    Mesh mesh = soup(whole);
    Random random(7);
    for (double& x : mesh.vertices) {
      const auto value = static_cast<float>(x);
      const float toward = random.integer(0, 1) == 0 ? value : INFINITY;
      x = std::nextafter(value, toward);
    }
    const double tolerance = weld_tolerance(mesh);
    EXPECT_LE(tolerance, 3e-7 * (1 + offset));
    const WeldSummary summary = weld(mesh, tolerance);
    EXPECT_EQ(summary.vertices, 216 - 49);
    EXPECT_LE(summary.distance, 2 * tolerance);  // from a first copy by way of a second
    EXPECT_TRUE(inspect(mesh).disk());
    expect_same_faces(mesh, whole, 2 * tolerance);
  }
}

TEST(Weld, DoublePrecisionFarFromTheOriginKeepsItsTolerance) {
  Mesh mesh = sheet(3, 3);
  for (double& x : mesh.vertices) x += 5.8e6;
  EXPECT_NEAR(weld_tolerance(mesh), 1e-7 * std::sqrt(2.0), 2e-9);  // the wave in z adds a little
  // Numbers that are of single precision by their few digits: quarters.
  Mesh quarters = sheet(4, 4);
  for (double& x : quarters.vertices) x = std::round(4 * x) / 4 + 5.8e5;
  EXPECT_LT(weld_tolerance(quarters), 2e-7);
  for (double& x : quarters.vertices) x -= 5.79e5;
  EXPECT_NEAR(weld_tolerance(quarters, true), std::sqrt(3.0) * 0x1p-23 * 1001, 1e-9) << "an STL file's";
}

TEST(Weld, NeverAcrossASlitThatIsWider) {
  // Two halves of a sheet along x = 0.5, the right one shifted in z.
  const auto halves = [](double shift) {
    Mesh mesh = sheet(6, 4);
    std::vector<std::int32_t> middle;
    for (std::int32_t j = 0; j <= 4; ++j) middle.push_back(7 * j + 3);
    std::vector<Index> right;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (f / 2 % 6 >= 3) right.push_back(f);
    cut_edges(mesh, middle, right, shift);
    return mesh;
  };
  const double tolerance = weld_tolerance(sheet(6, 4));
  for (const double shift : {0.0, 0.9 * tolerance}) {
    Mesh mesh = halves(shift);
    EXPECT_EQ(weld(mesh, tolerance).vertices, 5) << shift;
    EXPECT_TRUE(inspect(mesh).disk());
  }
  for (const double shift : {1.1 * tolerance, 1e-3}) {
    Mesh mesh = halves(shift);
    const WeldSummary summary = weld(mesh, tolerance);
    EXPECT_EQ(summary.vertices, 0) << shift;
    EXPECT_EQ(summary.parts_after, 2);
  }
  Mesh mesh = halves(1e-3);
  EXPECT_EQ(weld(mesh, 2e-3).vertices, 5) << "asked for";
  mesh = halves(1e-12);
  EXPECT_EQ(weld(mesh, 0).vertices, 0) << "equal places alone";
}

TEST(Weld, ASlitInASheetIsClosed) {
  // From the border inwards, and one inside: neither makes the sheet less of a disk.
  for (const bool inside : {false, true}) {
    Mesh mesh = sheet(6, 4);
    std::vector<Index> right;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (f / 2 % 6 >= 3) right.push_back(f);
    cut_edges(mesh, inside ? std::vector<std::int32_t>{10, 17, 24} : std::vector<std::int32_t>{3, 10, 17},
              right, 0);
    EXPECT_EQ(inspect(mesh).loop_edges.size(), inside ? 2U : 1U);
    EXPECT_EQ(weld(mesh, 1e-7).vertices, 3);
    EXPECT_TRUE(inspect(mesh).disk());
    EXPECT_EQ(inspect(mesh).loop_edges, (std::vector<Index>{20}));
  }
}

/// A tube or sphere of n x m cells cut open along one line: a disk whose border touches itself.
Mesh cut_open(int n, int m, bool sphere) {
  Mesh mesh = sheet(n, m);
  for (std::int32_t j = 0; j <= m; ++j)
    for (std::int32_t i = 0; i <= n; ++i) {
      const double t = 2 * std::numbers::pi * (i % n) / n, h = static_cast<double>(j) / m,
                   r = sphere ? std::sin(std::numbers::pi * (0.02 + 0.96 * h)) : 1;
      double* p = &mesh.vertices[3 * static_cast<std::size_t>(j * (n + 1) + i)];
      p[0] = r * std::cos(t), p[1] = r * std::sin(t), p[2] = h;
    }
  return mesh;
}

TEST(Weld, AMeshThatWasCutOpenStaysADisk) {
  Mesh mesh = cut_open(12, 5, false);
  ASSERT_TRUE(inspect(mesh).disk());
  const WeldSummary summary = weld(mesh, 1e-7);
  EXPECT_EQ(summary.vertices, 0);
  EXPECT_EQ(summary.left_apart, 6);
  EXPECT_TRUE(inspect(mesh).disk());
  EXPECT_EQ(mesh.vertex_count(), 13 * 6);
  // As a soup there is nothing that says where it was cut.
  mesh = soup(cut_open(12, 5, false));
  EXPECT_EQ(weld(mesh, 1e-7).parts_after, 1);
  EXPECT_EQ(inspect(mesh).loop_edges, (std::vector<Index>{12, 12}));
  // A Moebius band cut across is a disk too.
  mesh = band(8, true);
  cut_edges(mesh, {0, 1}, {0, 1}, 0);
  ASSERT_TRUE(inspect(mesh).disk());
  EXPECT_EQ(weld(mesh, 1e-7).left_apart, 2);
}

TEST(Weld, OneCutMeshBesideASoupStaysCut) {
  Mesh mesh = cut_open(10, 4, false);
  append(mesh, soup(sheet(3, 3)), 5);
  const WeldSummary summary = weld(mesh, 1e-7);
  EXPECT_EQ(summary.vertices, 54 - 16);
  EXPECT_EQ(summary.left_apart, 5);
  EXPECT_EQ(summary.parts_after, 2);
}

TEST(Weld, VerticesThatMerelyMeetStayApart) {
  Mesh mesh = sheet(2, 2);
  Mesh other = sheet(2, 2);
  append(mesh, other, 0);
  for (Index k = 9; k < 18; ++k)
    for (int d = 0; d < 3; ++d) mesh.vertices[3 * k + d] += mesh.vertices[24 + d];  // from corner to corner
  EXPECT_EQ(weld(mesh, 1e-7).vertices, 0);
  EXPECT_EQ(inspect(mesh).nonmanifold_vertex, -1);
}

TEST(Weld, ThreeSheetsAtOneEdgeAreSaidToBe) {
  Mesh mesh = sheet(2, 2), upright;
  upright = sheet(2, 2);
  for (Index k = 0; k < 9; ++k) {
    double* p = &upright.vertices[3 * k];
    p[2] += p[0], p[0] = 0;
  }
  append(mesh, upright, 0);
  Mesh left = sheet(2, 2);
  for (Index k = 0; k < 9; ++k) left.vertices[3 * k] *= -1;
  for (Index k = 0; k < 9; ++k) left.vertices[3 * k + 2] = mesh.vertices[3 * k + 2];
  append(mesh, left, 0);
  weld(mesh, 1e-7);
  EXPECT_EQ(inspect(mesh).parts, 1);
  EXPECT_GE(inspect(mesh).nonmanifold_edge[0], 0);
}

TEST(Weld, FacesWhoseCornersFallTogetherAreDegenerate) {
  Mesh mesh = soup(sheet(3, 3));
  // A needle between two faces of the soup: a side of no length.
  const auto first = static_cast<std::int32_t>(mesh.vertex_count());
  for (const std::int32_t v : {0, 1, 1})
    for (int d = 0; d < 3; ++d) mesh.vertices.push_back(Mesh(mesh).vertex(v)[d]);
  mesh.faces.push_back({first, first + 1, first + 2});
  weld(mesh, 1e-7);
  EXPECT_EQ(inspect(mesh).degenerate_face, 18);
  expect_throw<InvalidInput>([&] { require_disk(mesh); }, "is its corner twice");
  EXPECT_NO_THROW(require_disk(repair(mesh, {.drop_degenerate = true}).mesh));
}

TEST(Weld, EdgesShorterThanTheToleranceDoNotFallTogether) {
  Mesh mesh = sheet(40, 40);
  EXPECT_EQ(weld(mesh, 0.01).vertices, 0);  // a cell is 0.025 wide
  for (Index k = 0; k < mesh.vertex_count(); ++k) mesh.vertices[3 * k] *= 0.01;
  EXPECT_EQ(weld(mesh, 0.01).vertices, 0) << "and here 0.00025";
}

TEST(Weld, ParametersAreKeptWhereTheyAgree) {
  Mesh whole = sheet(4, 4);
  for (Index k = 0; k < whole.vertex_count(); ++k)
    whole.uv.insert(whole.uv.end(), {whole.vertex(k)[0], whole.vertex(k)[1]});
  Mesh mesh = soup(whole);
  EXPECT_EQ(weld(mesh, 1e-7).parameters, 0);
  EXPECT_EQ(static_cast<Index>(mesh.uv.size()), 2 * mesh.vertex_count());
  for (Index k = 0; k < mesh.vertex_count(); ++k) EXPECT_EQ(mesh.uv[2 * k], mesh.vertex(k)[0]);
  // Another chart for the upper half.
  Mesh charts = soup(whole);
  for (std::size_t k = charts.uv.size() / 2; k < charts.uv.size(); k += 2) charts.uv[k] += 2;
  Mesh joined = charts;
  EXPECT_EQ(weld(joined, 1e-7).parameters, 12);  // three corners a cell along the seam
  EXPECT_TRUE(joined.uv.empty());
  EXPECT_EQ(inspect(joined).parts, 1);
  const WeldSummary kept = weld(charts, 1e-7, true);
  EXPECT_EQ(kept.parameters, 0);
  EXPECT_EQ(kept.parts_after, 2);
  EXPECT_EQ(charts.vertex_count(), 30);
}

TEST(Weld, AFanOfManyCopiesOfOneVertexIsQuick) {
  Mesh fan;
  constexpr int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double a = 1.5 * k / n, b = 1.5 * (k + 1) / n;
    fan.vertices.insert(fan.vertices.end(),
                        {0, 0, 1, std::cos(a), std::sin(a), 0, std::cos(b), std::sin(b), 0});
    fan.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  EXPECT_EQ(weld(fan, 1e-7).parts_after, 1);
  EXPECT_EQ(fan.vertex_count(), n + 2);
  EXPECT_TRUE(inspect(fan).disk());
}

TEST(Weld, RefusesTolerancesThatAreNone) {
  Mesh mesh = sheet(2, 2);
  for (const double tolerance : {-1.0, std::nan(""), 0.1, HUGE_VAL})
    expect_throw<InvalidInput>([&] { weld(mesh, tolerance); }, "at most 1 % of the mesh's diagonal");
  expect_throw<InvalidInput>(
      [] {
        Mesh empty;
        weld(empty, 0);
      },
      "no faces");
}

}  // namespace
}  // namespace knotfit::test
