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

TEST(Registry, NamesTheFormatsThereAre) {
  for (const char* words : {"unknown extension .foo", "esri-ascii (.asc .grd)",
                            "csv (.csv .tsv .txt .xyz .pts .dat)", "npy (.npy)"})
    refuses("a.foo", "1 2 3\n", words);
  refuses("points", "1 2 3\n", "a name without an extension does not tell the format");
  for (const char* extension : {".tif", ".VTK", ".vtp"})
    refuses(std::string("a") + extension, "x",
            "files are not supported by this version; it reads esri-ascii");
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
  expect_throw<FileError>([&] { read_data(folder.file("cloud.vtp")); }, ".vtp files are not supported");
  std::ofstream(folder.file("good.csv")) << "1,2,3\n";
  EXPECT_EQ(std::get<PointTable>(read_data(folder.file("good.csv")).content).size(), 1);
}

}  // namespace
}  // namespace knotfit::test
