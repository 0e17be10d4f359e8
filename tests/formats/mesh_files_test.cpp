// Bad mesh files against what their README says is wrong, and real ones against their counts.
#include "support.h"
namespace knotfit::test {
namespace {

void refuses_file(const std::string& name, const std::string& words) {
  const std::string path = test_data("bad/" + name).string();
  expect_throw<FileError>([&] { read_data(path); }, words);
  expect_throw<FileError>([&] { read_data(path); }, path + ":");
}

/// Reads, but is no disk; what the repair that the message names makes is one.
void is_no_disk(const std::string& path, std::initializer_list<const char*> words,
                const MeshRepair& repair_by, bool repaired = true) {
  SCOPED_TRACE(path);
  const Mesh mesh = content<Mesh>(read_data(path));
  for (const char* w : words) expect_throw<InvalidInput>([&] { require_disk(mesh); }, w);
  if (repaired) {
    EXPECT_NO_THROW(require_disk(repair(mesh, repair_by).mesh));
  }
}

std::string bad(const char* name) {
  return test_data(std::string("bad/") + name).string();
}

TEST(BadMeshes, FilesThatCannotBeRead) {
  refuses_file("bad_truncated.ply", "claims 144 vertices");
  refuses_file("bad_truncated.ply", "the file ends at byte 1378, inside vertex 100 (counted from 0)");
  refuses_file("bad_ply_huge.ply", "claims 4000000000 vertices of 12 bytes, but only 48 bytes follow");
  refuses_file("bad_not_a_mesh.stl", "is not an STL file: it begins like a PNG image");
  refuses_file("bad_stl_count.stl", "claims 3000000000 triangles, which take 150000000000 bytes");
  refuses_file("bad_stl_count.stl", "room for 2");
  refuses_file("bad_face_index.obj", ":36: face 11 (counted from 1) names vertex 26, but there are 25");
}

TEST(BadMeshes, MeshesThatAreNoDisk) {
  is_no_disk(bad("bad_two_parts.obj"), {"2 parts", "of 98, 50 faces", "begins at face 99", "`largest_part`"},
             {.largest_part = true});
  is_no_disk(bad("bad_nonmanifold.obj"),
             {"vertices 28 and 29 has 3 faces", "face 99 (counted from 1, line 164)"}, {}, false);
  is_no_disk(bad("bad_bowtie.off"), {"vertex 35 (counted from 0", "non-manifold vertex", "`largest_part`"},
             {.largest_part = true});
  is_no_disk(bad("bad_two_loops.obj"), {"2 boundary loops, of 32, 8 edges", "`fill_holes`"},
             {.fill_holes = true});
  is_no_disk(bad("bad_misoriented.ply"), {"face 40 (counted from 0, line 114)", "`orient`"},
             {.orient = true});
  is_no_disk(bad("bad_degenerate.off"),
             {"vertices 14 and 15 are at the same place", "2 such faces", "`drop_degenerate`"},
             {.drop_degenerate = true});
}

void expect_disk(const Mesh& mesh, Index vertices, Index faces, Index loop) {
  EXPECT_EQ(mesh.vertex_count(), vertices);
  EXPECT_EQ(mesh.face_count(), faces);
  const MeshReport report = inspect(mesh);
  EXPECT_TRUE(report.disk());
  EXPECT_EQ(report.loop_edges, std::vector<Index>{loop});
  EXPECT_EQ(report.unused_vertices, 0);
}

TEST(MeshSamples, AreDisks) {
  expect_disk(content<Mesh>(read_data(sample("face.obj").string())), 17157, 34144, 168);
  expect_disk(content<Mesh>(read_data(test_data("mask.obj").string())), 1590, 3000, 178);
}

class SharedMeshes : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("KNOTFIT_DATA") == nullptr) GTEST_SKIP() << "KNOTFIT_DATA is not set";
  }
  static std::string path(const std::string& name) {
    return std::string(std::getenv("KNOTFIT_DATA")) + "/" + name;
  }
};

TEST_F(SharedMeshes, CountsAreThosePublished) {
  struct Known {
    const char* name;
    Index vertices, faces, loop;
  };
  for (const Known& k :
       {Known{"three_peaks.off", 1907, 3671, 141}, Known{"blade_patch.ply", 6922, 13286, 556},
        Known{"blade_half.ply", 49869, 98595, 1141}, Known{"demosthenes_front.ply", 4465, 8532, 396},
        Known{"skull_top.ply", 16280, 31854, 704}, Known{"hammer_half.ply", 15848, 30564, 1130},
        Known{"mountain.ply", 25600, 50562, 636}, Known{"cowhead.obj", 15049, 29999, 97},
        Known{"horizon.off", 841, 1600, 80}, Known{"saddle_sheet.stl", 2669, 5131, 205},
        Known{"cylinder_uneven.off", 8285, 16442, 126}}) {
    SCOPED_TRACE(k.name);
    expect_disk(content<Mesh>(read_data(path(k.name))), k.vertices, k.faces, k.loop);
  }
}

TEST_F(SharedMeshes, APlyWithoutFacesIsACloud) {
  const PointTable t = content<PointTable>(read_data(path("lidar_csite1.ply")));
  EXPECT_EQ(t.size(), 131622);
  EXPECT_TRUE(t.u.empty());
}

TEST_F(SharedMeshes, AClosedMeshIsNoDisk) {
  is_no_disk(path("bad_closed.off"), {"closed", "no boundary loop at all", "cut it open"}, {}, false);
}

}  // namespace
}  // namespace knotfit::test
