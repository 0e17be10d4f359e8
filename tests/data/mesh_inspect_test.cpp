#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "meshes.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

void refuses(const Mesh& mesh, std::initializer_list<const char*> words) {
  for (const char* w : words) expect_throw<InvalidInput>([&] { require_disk(mesh); }, w);
}

TEST(MeshInspection, ASheetIsADisk) {
  const MeshReport r = inspect(sheet(5, 3));
  EXPECT_TRUE(r.disk());
  EXPECT_TRUE(r.orientable);
  EXPECT_EQ(r.part_faces, std::vector<Index>{30});
  EXPECT_EQ(r.loop_edges, std::vector<Index>{16});
  EXPECT_EQ(r.euler_characteristic, 1);
  EXPECT_EQ(r.unused_vertices, 0);
  EXPECT_NO_THROW(require_disk(sheet(5, 3)));
}

TEST(MeshInspection, FacesTurnedAllTogetherAreADiskToo) {
  Mesh mesh = sheet(4, 4);
  for (auto& c : mesh.faces) std::swap(c[1], c[2]);
  EXPECT_TRUE(inspect(mesh).disk());
}

TEST(MeshInspection, UnusedVerticesDoNoHarm) {
  Mesh mesh = sheet(2, 2);
  mesh.vertices.insert(mesh.vertices.end(), {7, 7, 7});
  EXPECT_EQ(inspect(mesh).unused_vertices, 1);
  EXPECT_TRUE(inspect(mesh).disk());
}

TEST(MeshInspection, AClosedMeshHasNoLoop) {
  EXPECT_TRUE(inspect(torus(6, 5)).loop_edges.empty());
  EXPECT_EQ(inspect(torus(6, 5)).euler_characteristic, 0);
  refuses(torus(6, 5), {"the mesh is closed", "no boundary loop at all", "cut it open"});
}

TEST(MeshInspection, AHandleIsNoDisk) {
  Mesh mesh = torus(6, 5);
  mesh.faces.pop_back();
  const MeshReport r = inspect(mesh);
  EXPECT_EQ(r.loop_edges, std::vector<Index>{3});
  EXPECT_EQ(r.euler_characteristic, -1);
  refuses(mesh, {"1 handle (Euler characteristic -1)", "cut it open"});
}

TEST(MeshInspection, PartsAreCountedLargestFirst) {
  Mesh mesh = sheet(2, 2);
  append(mesh, sheet(4, 4), 5);
  append(mesh, sheet(1, 1), 9);
  const MeshReport r = inspect(mesh);
  EXPECT_EQ(r.parts, 3);
  EXPECT_EQ(r.part_faces, (std::vector<Index>{32, 8, 2}));
  refuses(mesh, {"3 parts", "of 32, 8, 2 faces", "begins at face 8 (counted from 0)", "`largest_part`"});
}

TEST(MeshInspection, LoopsAreCountedTheLongestFirst) {
  const Mesh mesh = with_hole(sheet(9, 9), 9, {{2, 2}, {6, 6}, {6, 7}});
  const MeshReport r = inspect(mesh);
  EXPECT_EQ(r.loop_edges, (std::vector<Index>{36, 6, 4}));
  EXPECT_EQ(r.euler_characteristic, -1);
  refuses(mesh, {"3 boundary loops, of 36, 6, 4 edges", "`fill_holes`"});
}

TEST(MeshInspection, AnEdgeOfThreeFaces) {
  Mesh mesh = sheet(3, 3);
  mesh.vertices.insert(mesh.vertices.end(), {0.5, 0.5, 1});
  mesh.faces.push_back({5, 6, 16});
  mesh.counted_from = 1;
  const MeshReport r = inspect(mesh);
  EXPECT_EQ(r.nonmanifold_edge[0], 5);
  EXPECT_EQ(r.nonmanifold_edge[1], 6);
  refuses(mesh, {"between vertices 6 and 7 has 3 faces", "the third is face 19 (counted from 1)"});
}

TEST(MeshInspection, AVertexOfTwoFans) {
  Mesh mesh = sheet(3, 3);
  mesh.vertices.insert(mesh.vertices.end(), {2, 2, 0, 2, 3, 0});
  mesh.faces.push_back({15, 16, 17});
  EXPECT_EQ(inspect(mesh).nonmanifold_vertex, 15);
  EXPECT_EQ(inspect(mesh).loop_edges, (std::vector<Index>{3, 12}));  // the longest in space first
  refuses(mesh, {"vertex 15", "non-manifold vertex", "`largest_part`"});
}

TEST(MeshInspection, APinchedSheetIsOnePartWithTwoFansAtAVertex) {
  // Two cells that touch at a vertex are gone: the vertex between them has two fans.
  const Mesh mesh = with_hole(sheet(4, 4), 4, {{1, 1}, {2, 2}});
  const MeshReport r = inspect(mesh);
  EXPECT_EQ(r.parts, 1);
  EXPECT_EQ(r.nonmanifold_vertex, 12);
  EXPECT_EQ(r.loop_edges.size(), 2U);  // the fans tell: both holes are one loop through the vertex
  refuses(mesh, {"vertex 12", "a vertex of its own"});
}

TEST(MeshInspection, AFaceAgainstItsNeighbours) {
  Mesh mesh = sheet(4, 4);
  std::swap(mesh.faces[13][0], mesh.faces[13][1]);
  mesh.face_line.assign(mesh.faces.size(), 0);
  mesh.face_line[13] = 77;
  EXPECT_EQ(inspect(mesh).misoriented_face, 13);
  EXPECT_TRUE(inspect(mesh).orientable);
  EXPECT_EQ(inspect(mesh).loop_edges.size(), 1U);
  refuses(mesh, {"face 13 (counted from 0, line 77)", "misoriented", "`orient`"});
}

TEST(MeshInspection, AMoebiusBandHasNoOrientation) {
  EXPECT_FALSE(inspect(band(9, true)).orientable);
  EXPECT_EQ(inspect(band(9, true)).loop_edges.size(), 1U);
  EXPECT_TRUE(inspect(band(9, false)).orientable);
  EXPECT_EQ(inspect(band(9, false)).loop_edges.size(), 2U);
  refuses(band(9, true), {"Moebius", "cut it open"});
}

TEST(MeshInspection, FacesOfNoArea) {
  Mesh mesh = sheet(3, 3);
  mesh.faces.push_back({4, 4, 5});
  EXPECT_EQ(inspect(mesh).degenerate_face, 18);
  EXPECT_EQ(inspect(mesh).parts, 1);
  EXPECT_EQ(inspect(mesh).loop_edges, std::vector<Index>{12});
  refuses(mesh, {"face 18", "vertex 4 is its corner twice", "`drop_degenerate` removes it"});
  mesh.faces.back() = {0, 1, 2};
  for (int k = 0; k < 3; ++k) mesh.vertices[static_cast<std::size_t>(3 * k + 2)] = 0;
  EXPECT_EQ(inspect(mesh).degenerate_face, 18);
  refuses(mesh, {"its corners lie on a line"});
}

TEST(MeshInspection, ThinFacesAreNotDegenerateAtAnyScale) {
  for (const double scale : {1e-150, 1e-9, 1.0, 1e9, 1e150}) {
    Mesh mesh;
    mesh.vertices = {0, 0, 0, scale, 0, 0, 0.5 * scale, 1e-12 * scale, 0};
    mesh.faces = {{0, 1, 2}};
    EXPECT_LT(inspect(mesh).degenerate_face, 0) << scale;
    mesh.vertices[7] = 1e-16 * scale;
    EXPECT_EQ(inspect(mesh).degenerate_face, 0) << scale;
  }
}

TEST(MeshInspection, RefusesWhatIsNoMesh) {
  const auto refuse = [](const Mesh& mesh, const char* words) {
    expect_throw<InvalidInput>([&] { inspect(mesh); }, words);
  };
  refuse({}, "no faces");
  Mesh mesh = sheet(1, 1);
  mesh.faces[1][2] = 4;
  refuse(mesh, "face 1 of the mesh names vertex 4, but there are 4 vertices");
  mesh.faces[1][2] = -1;
  refuse(mesh, "names vertex -1");
  mesh = sheet(1, 1);
  mesh.vertices[4] = std::numeric_limits<double>::quiet_NaN();
  refuse(mesh, "vertex 1 of the mesh is not finite");
  mesh.vertices.pop_back();
  refuse(mesh, "not three a vertex");
}

// Counts by sets and maps: slow and plain.
struct Counts {
  Index parts = 0, loops = 0;
  int euler = 0;
  bool manifold_edges = true;
};

Counts slow_counts(const Mesh& mesh) {
  std::map<std::pair<int, int>, std::vector<int>> edges;
  std::set<int> vertices;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.faces[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)],
                b = mesh.faces[static_cast<std::size_t>(f)][static_cast<std::size_t>((k + 1) % 3)];
      vertices.insert(a);
      edges[{std::min(a, b), std::max(a, b)}].push_back(f);
    }
  Counts out;
  out.euler = static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
              static_cast<int>(mesh.face_count());
  std::vector<int> part(mesh.faces.size());
  std::iota(part.begin(), part.end(), 0);
  for (bool again = true; again;) {
    again = false;
    for (const auto& [e, faces] : edges) {
      int least = part[static_cast<std::size_t>(faces[0])];
      for (const int f : faces) least = std::min(least, part[static_cast<std::size_t>(f)]);
      for (const int f : faces)
        again = std::exchange(part[static_cast<std::size_t>(f)], least) != least || again;
    }
  }
  out.parts = static_cast<Index>(std::set<int>(part.begin(), part.end()).size());
  for (const auto& [e, faces] : edges) out.manifold_edges = out.manifold_edges && faces.size() < 3;
  return out;
}

TEST(MeshInspection, AgreesWithASlowCountOnRandomFaces) {
  Random random;
  for (int round = 0; round < 300; ++round) {
    Mesh mesh = sheet(random.integer(1, 6), random.integer(1, 6));
    std::vector<std::array<std::int32_t, 3>> faces;
    for (const auto& c : mesh.faces)
      if (random.unit() < 0.8) faces.push_back(c);
    for (int extra = random.integer(0, 2); extra > 0; --extra) {
      const auto n = static_cast<int>(mesh.vertex_count());
      const std::int32_t a = random.integer(0, n - 1), b = random.integer(0, n - 1),
                         c = random.integer(0, n - 1);
      if (a != b && b != c && c != a) faces.push_back({a, b, c});
    }
    if (faces.empty()) continue;
    mesh.faces = faces;
    const MeshReport r = inspect(mesh);
    const Counts slow = slow_counts(mesh);
    EXPECT_EQ(r.parts, slow.parts);
    EXPECT_EQ(r.euler_characteristic, slow.euler);
    EXPECT_EQ(r.nonmanifold_edge[0] < 0, slow.manifold_edges);
  }
}

TEST(MeshInspection, AMillionFacesInSeconds) {
  const Mesh mesh = sheet(708, 708);
  ASSERT_GT(mesh.face_count(), 1000000);
  const auto start = std::chrono::steady_clock::now();
  const MeshReport r = inspect(mesh);
  EXPECT_TRUE(r.disk());
  EXPECT_EQ(r.loop_edges, std::vector<Index>{4 * 708});
  // Some 0.4 s on one core; the bound is for loaded machines and sanitizers.
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 20);
}

}  // namespace
}  // namespace knotfit::test
