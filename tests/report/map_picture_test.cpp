#include "knotfit/map_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_mesh.h"
#include "knotfit/threads.h"
#include "mapped_sheet.h"
#include "pixels.h"
#include "report/map_content.h"
#include "report/map_view.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using test::expect_throw;
using test::sheet;

MapPictureInput input_of(const Mesh& mesh, const std::vector<double>& uv) {
  MapPictureInput input;
  input.mesh = &mesh;
  input.uv = &uv;
  return input;
}

void expect_colour(std::uint32_t pixel, const report::Rgb& c, const char* what) {
  const double channels[3] = {c.r, c.g, c.b};
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(pixel >> (16 - 8 * k) & 0xFF, 255 * channels[k], 3) << what;
}

TEST(MapPicture, IsAFileOfTheFormatAskedFor) {
  const Mesh mesh = sheet(6);
  const MapPictureInput input = input_of(mesh, mesh.uv);
  EXPECT_EQ(draw_map_picture(input, ".png").substr(1, 3), "PNG");
  EXPECT_NE(draw_map_picture(input, ".svg").find("<svg"), std::string::npos);
  EXPECT_EQ(draw_map_picture(input, ".pdf").substr(0, 4), "%PDF");
  const Pixels small = decode(draw_map_picture(input, ".png", {.width = 200, .height = 240}));
  EXPECT_EQ(small.width, 200);
  EXPECT_EQ(small.height, 240);
  EXPECT_EQ(decode(draw_map_picture(input, ".png", {.width = 900, .height = 1600})).height, 1600);
}

TEST(MapPicture, RefusesWhatItCannotDraw) {
  const Mesh mesh = sheet(2);
  MapPictureInput input = input_of(mesh, mesh.uv);
  expect_throw<InvalidInput>([&] { draw_map_picture(input, ".gif"); },
                             "\".gif\" is no extension of a picture");
  expect_throw<InvalidInput>([&] { draw_map_picture(input, ".png", {.width = 100}); }, "width of 100");
  input.parts = 201;
  expect_throw<InvalidInput>([&] { draw_map_picture(input, ".png"); }, "201 parts");
  input.parts = 0;
  expect_throw<InvalidInput>([&] { draw_map_picture(input, ".png"); }, "0 parts");
  input.parts = 4;
  input.corners = {0, 1, 2, 9};
  expect_throw<InvalidInput>([&] { draw_map_picture(input, ".png"); }, "no vertex 9");
  expect_throw<InvalidInput>([&] { draw_map_picture({}, ".png"); }, "needs a mesh");
  std::vector<double> uv(17, 0.5);
  expect_throw<InvalidInput>([&] { draw_map_picture(input_of(mesh, uv), ".png"); }, "there are 17");
}

TEST(MapPicture, TellsTheSameFiguresAsTheMeasure) {
  const Mesh mesh = sheet(12, 2, [](double u, double v) { return 0.4 * std::sin(4 * u) * v; });
  const MapPictureInput input = input_of(mesh, mesh.uv);
  const report::MapContent content = report::prepare(input);
  const MapQuality quality = measure_map(mesh, mesh.uv);
  EXPECT_EQ(content.quality.stretch, quality.stretch);
  const report::Facts facts = report::facts_of(content);
  std::vector<std::string> names;
  for (const auto& [name, value] : facts) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"L2 stretch", "on its rectangle", "rectangle",
                                             "stretch of faces", "worst angle", "flipped", "triangles"}));
  EXPECT_EQ(facts[5].second, "0");
  EXPECT_EQ(facts[6].second, "288");
}

// The square of two triangles, one twice as stretched in u as the other: colours by hand.
TEST(MapPicture, ColoursFacesByTheirStretch) {
  const Mesh mesh = sheet(8);
  std::vector<double> uv = mesh.uv;  // u -> u^2: stretched near u = 0
  for (std::size_t k = 0; k < uv.size(); k += 2) uv[k] *= uv[k];
  const MapPictureInput input = input_of(mesh, uv);
  const report::MapContent content = report::prepare(input);
  EXPECT_FALSE(content.turned);
  EXPECT_FALSE(content.virtual_faces);
  EXPECT_GE(content.range, *std::max_element(content.stretch.begin(), content.stretch.end()) - 1e-12);
  report::Canvas canvas(report::Format::png, 700, 700);
  const report::Box box = report::draw_map_plane(canvas, content, {0, 0, 700, 700}, 17);
  const Pixels page = decode(canvas.finish());
  for (const Index face : {Index{0}, Index{60}, Index{127}}) {
    const auto& t = mesh.faces[face];
    double u = 0, v = 0;
    for (const std::int32_t i : t) u += uv[2 * i] / 3, v += uv[2 * i + 1] / 3;
    // A place of the face off the lines u, v = k/20.
    const auto off = [](double x) { return (std::floor(20 * x) + 0.5) / 20; };
    const double a = face == 0 ? u : off(u), b = face == 0 ? v : off(v);
    expect_colour(page.at(box.x + a * box.width, box.bottom() - b * box.height), content.colour(face),
                  "face");
  }
}

TEST(MapPicture, MarksTurnedAndVirtualFaces) {
  Mesh mesh = sheet(4);
  mesh.virtual_face.assign(mesh.faces.size(), 0);
  mesh.virtual_face[31] = 1;
  std::vector<double> uv = mesh.uv;
  uv[2 * 6] = 0.9;  // vertex (1, 1) beyond its neighbours
  const MapPictureInput input = input_of(mesh, uv);
  const report::MapContent content = report::prepare(input);
  EXPECT_TRUE(content.turned);
  EXPECT_TRUE(content.virtual_faces);
  EXPECT_TRUE(std::isnan(content.stretch[31]));
  EXPECT_EQ(content.colour(31).r, report::kNoData.r);
  Index turned = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (f != 31 && std::isnan(content.stretch[f])) {
      EXPECT_EQ(content.colour(f).r, report::kTurned.r);
      ++turned;
    }
  EXPECT_EQ(turned, content.quality.flipped);
  EXPECT_GT(turned, 0);
  EXPECT_FALSE(draw_map_picture(input, ".png").empty());
}

TEST(MapPicture, BordersAreTheFirstAndLastLineOfEachDirection) {
  const Mesh mesh = sheet(3);
  MapPictureInput input = input_of(mesh, mesh.uv);
  input.parts = 5;
  const report::MapContent content = report::prepare(input);
  ASSERT_EQ(content.lines.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_EQ(content.border(k), k == 0 || k == 5 || k == 6 || k == 11) << k;
}

TEST(MapPicture, IsTheSameForAnyNumberOfThreads) {
  const Mesh mesh = sheet(10, 1, [](double u, double v) { return u * v; });
  const MapPictureInput input = input_of(mesh, mesh.uv);
  set_thread_count(1);
  const std::string one = draw_map_picture(input, ".png");
  set_thread_count(2);
  EXPECT_EQ(draw_map_picture(input, ".png"), one);
  set_thread_count(0);
}

}  // namespace
}  // namespace knotfit
