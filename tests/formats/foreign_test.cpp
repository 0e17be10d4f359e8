// Files of other programs: told by their first bytes, with the command that converts them.
#include "formats/foreign.h"

#include "knotfit/curve_io.h"
#include "support.h"
namespace knotfit::test {
namespace {

using namespace std::string_literals;

struct Sample {
  std::string name, bytes, what, command;
};

std::string las_header(int point_format) {
  std::string bytes = "LASF" + std::string(371, '\0');
  bytes[24] = 1;
  bytes[25] = 2;
  bytes[104] = static_cast<char>(point_format);
  return bytes;
}

std::string zip_of(const std::string& first, const std::string& second) {
  const auto member = [](const std::string& name) {
    std::string head = "PK\x03\x04"s + std::string(22, '\0');
    head += static_cast<char>(name.size());
    return head + std::string(3, '\0') + name + "body";
  };
  return member(first) + member(second);
}

std::vector<Sample> samples() {
  return {
      {"a.tif", "II*\0\x08\0\0\0"s, "a GeoTIFF raster", "gdal_translate -of AAIGrid a.tif a.asc"},
      {"a.tiff", "MM\0*\0\0\0\x08"s, "a GeoTIFF raster", "gdal_translate -of AAIGrid a.tiff a.asc"},
      {"big.tif", "II+\0\x08\0\0\0"s, "a GeoTIFF raster", "gdal_translate -of AAIGrid big.tif big.asc"},
      // The command never writes over the file that it reads.
      {"a.asc", "DSAA\n3 2\n", "a Surfer grid", "gdal_translate -of AAIGrid a.asc a_converted.asc"},
      {"a.las", las_header(131), "a compressed point cloud (LAZ)", "pdal translate a.las a_converted.las"},
      {"a.npy", zip_of("x.npy", "y.npy"), "an archive of NumPy arrays (.npz)",
       "numpy.save('a_converted.npy'"},
      {"a.laz", las_header(131), "a compressed point cloud (LAZ)", "pdal translate a.laz a.las"},
      {"a.copc.laz", las_header(134), "LAZ", "pdal translate a.copc.laz a.copc.las"},
      {"a.e57", "ASTM-E57\1\0\0\0"s, "an E57 point cloud", "pdal translate a.e57 a.las"},
      {"a.glb", "glTF\2\0\0\0"s, "a glTF model", "assimp export a.glb a.obj"},
      {"a.gltf", "{\n \"asset\": {\"version\": \"2.0\"},\n \"buffers\": []}", "a glTF model",
       "assimp export a.gltf a.obj"},
      {"a.3mf", zip_of("[Content_Types].xml", "3D/3dmodel.model"), "a 3MF model",
       "assimp export a.3mf a.obj"},
      {"a.xlsx", zip_of("[Content_Types].xml", "xl/workbook.xml"), "a spreadsheet (XLSX)",
       "libreoffice --headless --convert-to csv a.xlsx"},
      {"a.ods", zip_of("mimetype", "application/vnd.oasis.opendocument.spreadsheet"), "a spreadsheet (ODS)",
       "libreoffice --headless --convert-to csv a.ods"},
      {"a.xls", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1 and more"s, "a spreadsheet (XLS)",
       "libreoffice --headless --convert-to csv a.xls"},
      {"a.npz", zip_of("arr_0.npy", "arr_1.npy"), "an archive of NumPy arrays (.npz)",
       "numpy.load('a.npz'); numpy.save('a.npy'"},
      {"a.zip", zip_of("cloud.xyz", "readme.txt"), "a ZIP archive", "unzip a.zip"},
      {"a.csv.gz", "\x1F\x8B\x08\0"s, "a gzip file", "gunzip -k a.csv.gz"},
      {"a.xz", "\xFD"s + "7zXZ\0"s, "an xz file", "unxz -k a.xz"},
      {"a.7z", "7z\xBC\xAF\x27\x1C"s, "a 7z archive", "7z x a.7z"},
      {"a.vtk", "# vtk DataFile Version 3.0\n", "a VTK file", "meshio convert a.vtk a.ply"},
      {"a.vtu", "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">", "a VTK file",
       "meshio convert a.vtu a.ply"},
      {"a.nc", "\x89HDF\r\n\x1A\n"s, "a netCDF grid", "gdal_translate -of AAIGrid a.nc a.asc"},
      {"a.grd", "DSAA\n3 2\n", "a Surfer grid", "gdal_translate -of AAIGrid a.grd a.asc"},
      {"a.fbx", "Kaydara FBX Binary  \0"s, "an FBX model", "assimp export a.fbx a.obj"},
  };
}

TEST(ForeignFiles, AreToldByTheirBytesWhateverTheirName) {
  for (const Sample& s : samples()) {
    refuses(s.name, s.bytes, s.name + ": is " + s.what.substr(s.what == "LAZ" ? 3 : 0));
    refuses(s.name, s.bytes, s.command);
    refuses(s.name, s.bytes, s.what);
    for (const char* name : {"data", "data.csv", "data.asc", "data.ply", "data.xyz", "data.las"})
      refuses(name, s.bytes, s.what);
    ReadOptions options;
    options.format = "csv";
    refuses("data.txt", s.bytes, s.what, options);
  }
}

TEST(ForeignFiles, AreToldByTheirExtensionWhereTheBytesTellNothing) {
  for (const char* name : {"a.tif", "A.TIFF", "a.img", "a.dem", "a.nc"})
    refuses(name, "something", "gdal_translate -of AAIGrid");
  for (const char* name : {"a.e57", "a.laz"}) refuses(name, "something", "pdal translate");
  for (const char* name : {"a.glb", "a.gltf", "a.3mf", "a.fbx", "a.dae", "a.3ds"})
    refuses(name, "something", "assimp export");
  for (const char* name : {"a.xlsx", "a.xls", "a.ods"}) refuses(name, "something", "libreoffice");
  refuses("a.npz", "something", "numpy.save");
  // Bytes of a format that is read win, and so does a name.
  EXPECT_EQ(read("a.img", doubles("1, 3", {1, 2, 3})).format, "npy");
  ReadOptions options;
  options.format = "csv";
  EXPECT_EQ(read("a.dem", "1 2 3\n", options).format, "csv");
}

TEST(ForeignFiles, NamesAreQuotedForTheShell) {
  refuses("my scan's.tif", "II*\0"s, "AAIGrid 'my scan'\\''s.tif' 'my scan'\\''s.asc'");
  refuses("deep/er/a.laz", las_header(131), "pdal translate deep/er/a.laz deep/er/a.las");
  refuses("standard input", "ASTM-E57", "convert it: pdal translate FILE FILE.las");
  refuses("-a.e57", "ASTM-E57", "pdal translate '-a.e57' '-a.las'");
}

TEST(ForeignFiles, SurfacesAndCurvesAreNoOthers) {
  const TemporaryFolder folder;
  for (const Sample& s : samples()) {
    const std::string path = folder.file("a.json");
    std::ofstream(path, std::ios::binary) << s.bytes;
    expect_throw<FileError>([&] { read_surface(path); }, s.what);
    expect_throw<FileError>([&] { read_curve(path); }, s.what);
    const std::string data = folder.file("a.bin");
    std::ofstream(data, std::ios::binary) << s.bytes;
    expect_throw<FileError>([&] { read_data(data); }, s.what);
  }
}

TEST(ForeignFiles, ALargeOneIsNotReadFirst) {
  const TemporaryFolder folder;
  const std::string path = folder.file("large.tif");
  std::ofstream(path, std::ios::binary) << "II*\0"s;
  std::filesystem::resize_file(path, std::uintmax_t{1} << 42);  // 4 TB that are not there
  expect_throw<FileError>([&] { read_data(path); }, "a GeoTIFF raster");
}

TEST(ForeignFiles, WhatIsReadIsNone) {
  EXPECT_EQ(foreign_file("1 2 3\n", "a.csv"), "");
  EXPECT_EQ(foreign_file("MMXX,3,4\n", "a.csv"), "");
  EXPECT_EQ(foreign_file("BZhu,1,2\n", "a.csv"), "");
  EXPECT_EQ(foreign_file(las_header(3), "a.las"), "");
  EXPECT_EQ(foreign_file("{\"format\": \"knotfit-surface\"}", "a.json"), "");
  EXPECT_EQ(foreign_file("", "a"), "");
}

}  // namespace
}  // namespace knotfit::test
