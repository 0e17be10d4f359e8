#include <gtest/gtest.h>

#include "formats/cad/occt.h"
#include "formats/support.h"
#include "knotfit/cad.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

Surface sheet() {
  const KnotVector k = KnotVector::uniform(3, 1);
  std::vector<double> net;
  for (const double a : k.greville())
    for (const double b : k.greville()) net.insert(net.end(), {10 * a, 10 * b, a * b});
  return Surface(k, k, 3, std::move(net));
}

std::string text_of(CadFormat format) {
  const TemporaryFolder folder;
  write_cad(folder.file("a"), {sheet()}, {.format = format}, false);
  return bytes_of(folder.file("a"));
}

class BadCad : public testing::Test {
 protected:
  std::string put(const std::string& text, const std::string& name = "a.step") const {
    std::ofstream(folder_.file(name), std::ios::binary) << text;
    return folder_.file(name);
  }
  void refused(const std::string& text, const std::string& words, const std::string& name = "a.step") const {
    const std::string path = put(text, name);
    expect_throw<FileError>([&] { read_cad(path); }, words);
    expect_throw<FileError>([&] { read_cad(path); }, path);
  }
  TemporaryFolder folder_;
};

TEST_F(BadCad, NamesWhatIsWrong) {
  refused("", "the file is empty");
  refused("solid nothing\n", "is neither STEP (ISO-10303-21) nor IGES");
  refused(std::string(5000, '\xA7'), "is neither STEP");
  expect_throw<FileError>([&] { read_cad(folder_.file("none.step")); }, "no such file");
  expect_throw<FileError>([&] { read_cad(folder_.path().string()); }, "is a folder");
  const std::string empty =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 "
      "}'));\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0."
      "));\nENDSEC;\nEND-ISO-10303-21;\n";
  refused(empty, "holds no B-spline surface");
}

TEST_F(BadCad, AStepFileThatIsCutOffIsAnError) {
  const std::string text = text_of(CadFormat::step_ap242);
  for (std::size_t size = 64; size + 20 < text.size(); size += 997)
    refused(text.substr(0, size), "the STEP file is cut off");
  EXPECT_NO_THROW(read_cad(put(text + "\r\n \n")));
}

TEST_F(BadCad, AnIgesFileThatIsCutOffIsAnError) {
  const std::string text = text_of(CadFormat::iges);
  for (std::size_t lines = 1; lines * 81 < text.size(); lines += 7)
    refused(text.substr(0, lines * 81), "cut off", "a.igs");
  for (std::size_t size = 100; size + 81 < text.size(); size += 331)
    refused(text.substr(0, size), "a.igs", "a.igs");
  std::string fewer = text;
  fewer.erase(fewer.find("P0000003") - 72, 81);
  refused(fewer, "its section P has", "a.igs");
  std::string dos;
  for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_cad(put(dos, "dos.igs")).front(), sheet());
}

// OpenCASCADE 7.6 crashes on both.
TEST_F(BadCad, EmptyListsAndCirclesOfReferencesAreErrors) {
  const std::string text = text_of(CadFormat::step_ap242);
  const std::size_t curve = text.find("SURFACE_CURVE('',#"), list = text.find(",(#", curve);
  std::string empty = text;
  empty.erase(list + 2, empty.find(')', list) - list - 2);
  refused(empty, "a list of SURFACE_CURVE is empty");
  const std::size_t begin = text.rfind('#', curve), first = curve + 17, comma = text.find(',', first);
  std::string round = text;
  const std::string itself = text.substr(begin, text.find(' ', begin) - begin);
  round.replace(first, comma - first, itself);
  refused(round, "entity " + itself + " leads back to itself");
  // By way of another: the edge that leads to the curve.
  const std::size_t edge = text.rfind("EDGE_CURVE(", curve), edge_id = text.rfind('#', edge);
  ASSERT_NE(edge, std::string::npos);
  round = text;
  round.replace(first, comma - first, text.substr(edge_id, text.find(' ', edge_id) - edge_id));
  refused(round, "leads back to itself");
}

TEST_F(BadCad, ARationalSurfaceIsRefusedByName) {
  // Weights of an IGES surface: one of them doubled.
  std::string text = text_of(CadFormat::iges);
  const std::size_t last_knots = text.find("1.0000000000000000E+00", text.find("\n128,") + 1200);
  text[last_knots] = '2';
  const std::size_t flag = text.find("128,4,4,3,3,0,0,1,0,0,");
  ASSERT_NE(flag, std::string::npos);
  text[flag + 16] = '0';
  refused(text, "rational", "a.igs");
}

TEST(CadFaces, OneThatIsNotUsableDoesNotHideTheOthers) {
  const std::string path = test_data("../cli/reports/two_faces_first_rational.igs").string();
  const std::vector<CadFace> faces = read_cad_faces(path);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].kind, "rational B-spline surface");
  EXPECT_FALSE(faces[0].surface);
  EXPECT_NE(faces[0].why.find("weights that differ"), std::string::npos) << faces[0].why;
  EXPECT_EQ(faces[1].kind, "B-spline surface");
  ASSERT_TRUE(faces[1].surface);
  EXPECT_EQ(faces[1].why, "");
  EXPECT_FALSE(faces[1].trimmed);
  EXPECT_EQ(read_cad(path), std::vector<Surface>{*faces[1].surface});
}

}  // namespace
}  // namespace knotfit::test
