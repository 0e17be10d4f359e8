#include <set>

#include "support.h"
namespace knotfit::test {
namespace {

TEST(Registry, ListsEveryFormatOnce) {
  std::set<std::string_view> names;
  for (const FormatInfo& info : formats()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.summary.empty());
    // CAD files go through cad.h, where it is built in.
    EXPECT_TRUE(info.reads || info.writes || info.name == "step" || info.name == "iges");
  }
  for (const char* name :
       {"esri-ascii", "csv", "rows", "npy", "npy-grid", "ply", "obj", "off", "stl", "vtk", "knotfit-json"})
    EXPECT_TRUE(names.contains(name)) << name;
}

const char* const kGrid = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n";

TEST(Registry, TheExtensionTells) {
  EXPECT_EQ(read("a.asc", kGrid).format, "esri-ascii");
  EXPECT_EQ(read("a.GRD", kGrid).format, "esri-ascii");
  EXPECT_EQ(read("A.CSV", "1,2,3\n").format, "csv");
  EXPECT_EQ(read("a.b.txt", "1 2 3\n").format, "csv");
  EXPECT_EQ(read("a.rows", "1 2 3\n").format, "rows");
  EXPECT_EQ(read("a.npy", doubles("1, 3", {1, 2, 3})).format, "npy");
  EXPECT_EQ(read("folder.npy/a.csv", "1,2,3\n").path, "folder.npy/a.csv");
}

TEST(Registry, ThenTheContent) {
  EXPECT_EQ(read("a", kGrid).format, "esri-ascii");
  EXPECT_EQ(read("a.txt", kGrid).format, "esri-ascii");
  EXPECT_EQ(read("a.bin", doubles("1, 3", {1, 2, 3})).format, "npy");
  EXPECT_EQ(read("a", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").format, "off");
  EXPECT_EQ(read("a",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
                 "end_header\n1 2 3\n")
                .format,
            "ply");
}

TEST(Registry, ANameWins) {
  ReadOptions options;
  options.format = "csv";
  EXPECT_EQ(read("a.asc", "1 2 3\n", options).format, "csv");
  EXPECT_EQ(read("a.ply", "1 2 3\n", options).format, "csv");
  options.format = "esri-ascii";
  EXPECT_EQ(read("a.ply", kGrid, options).format, "esri-ascii");
  for (const char* name : {"step", "vtk", "knotfit-json"}) {
    options.format = name;
    expect_throw<InvalidInput>([&] { read("a.asc", kGrid, options); }, "unknown input format");
  }
}

TEST(Registry, EveryTextMayEndWithCtrlZ) {
  const std::pair<const char*, const char*> files[] = {
      {"a.asc", kGrid},
      {"a.csv", "x,y,z\n1,2,3\n4,5,6\n"},
      {"a.xyz", "1 2 3\n4 5 6\n"},
      {"a.rows", "1 2 3\n\n4 5 6\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
       "endfacet\nendsolid a\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
       "end_header\n1 2 3\n"},
      {"a.pcd",
       "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
       "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3\n"}};
  for (const auto& [name, text] : files) {
    SCOPED_TRACE(name);
    const SourceData plain = read(name, text);
    for (const char* end : {"\x1A", "\r\n\x1A\r\n", "\x1A\x1A\x1A"}) {
      const SourceData marked = read(name, std::string(text) + end);
      EXPECT_EQ(marked.format, plain.format);
      EXPECT_EQ(marked.content.index(), plain.content.index());
      if (const auto* points = std::get_if<PointTable>(&plain.content)) {
        EXPECT_EQ(std::get<PointTable>(marked.content).z, points->z);
      }
      if (const auto* grid = std::get_if<Raster>(&plain.content)) {
        EXPECT_EQ(std::get<Raster>(marked.content).z, grid->z);
      }
      if (const auto* rows = std::get_if<PointRows>(&plain.content)) {
        EXPECT_EQ(std::get<PointRows>(marked.content).xyz, rows->xyz);
      }
      if (const auto* mesh = std::get_if<Mesh>(&plain.content)) {
        EXPECT_EQ(std::get<Mesh>(marked.content).vertices, mesh->vertices);
      }
    }
  }
  EXPECT_EQ(surface_from_json("{\"degree\": [1, 1], \"knots_u\": [0, 0, 1, 1], \"knots_v\": [0, 0, 1, 1], "
                              "\"control_points\": [[[1], [2]], [[3], [4]]]}\r\n\x1A",
                              "a.json")
                .surface.net(),
            (std::vector<double>{1, 2, 3, 4}));
}

TEST(Registry, CountsOfEveryHeaderMayBeWrittenAsFloatingPointNumbers) {
  EXPECT_EQ(content<Mesh>(read("a.off", "OFF\n3.0 1.0 0.0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).face_count(), 1);
  EXPECT_EQ(content<PointTable>(read("a.ply",
                                     "ply\nformat ascii 1.0\nelement vertex 1.0\nproperty int x\n"
                                     "property int y\nproperty int z\nend_header\n1 2 3\n"))
                .z,
            std::vector<double>{3});
  EXPECT_EQ(content<PointTable>(read("a.pcd",
                                     "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                     "WIDTH 2.0\nHEIGHT 1.0\nPOINTS 2.0\nDATA ascii\n1 2 3\n4 5 6\n"))
                .z,
            (std::vector<double>{3, 6}));
}

TEST(Registry, NamesTheFormatsThereAre) {
  for (const char* words : {"unknown extension .foo", "esri-ascii (.asc .grd)",
                            "csv (.csv .tsv .txt .xyz .pts .dat)", "npy (.npy)"})
    refuses("a.foo", "1 2 3\n", words);
  refuses("points", "1 2 3\n", "a name without an extension does not tell the format");
  refuses("a.foo", "1 2 3\n", "`format`");
  refuses("a.json", "{}", "holds a knotfit surface, not points");
}

TEST(Registry, FilesThatCannotBeRead) {
  const TemporaryFolder folder;
  expect_throw<FileError>([&] { read_data(folder.file("none.csv")); }, "none.csv: no such file");
  expect_throw<FileError>([&] { read_data(folder.file("none.ply")); }, "no such file");
  expect_throw<FileError>([&] { read_data(folder.file("none/a.csv")); }, "no such file");
  expect_throw<FileError>([&] { read_data(folder.path().string()); }, "is a folder, not a file");
  expect_throw<FileError>([&] { read_data("/dev/zero"); }, "is neither a file nor a pipe");
  expect_throw<FileError>([&] { read_data(""); }, "no file name given");
  std::ofstream(folder.file("empty.csv")).flush();
  expect_throw<FileError>([&] { read_data(folder.file("empty.csv")); }, "the file is empty");
  std::ofstream(folder.file("cloud.vtp")) << "<VTKFile>";
  expect_throw<FileError>([&] { read_data(folder.file("cloud.vtp")); }, "is a VTK file");
  std::ofstream(folder.file("good.csv")) << "1,2,3\n";
  EXPECT_EQ(std::get<PointTable>(read_data(folder.file("good.csv")).content).size(), 1);
}

}  // namespace
}  // namespace knotfit::test
