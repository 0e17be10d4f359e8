#include "knotfit/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "pixels.h"
#include "report/colour_map.h"
#include "report/layout.h"
#include "report/parameter_plane.h"
#include "scenes.h"
namespace knotfit {
namespace {

int channel(std::uint32_t pixel, int which) {
  return static_cast<int>(pixel >> (16 - 8 * which) & 0xFF);
}

void expect_colour(std::uint32_t pixel, const report::Rgb& c, int slack = 3) {
  EXPECT_NEAR(channel(pixel, 0), 255 * c.r, slack);
  EXPECT_NEAR(channel(pixel, 1), 255 * c.g, slack);
  EXPECT_NEAR(channel(pixel, 2), 255 * c.b, slack);
}

// Where a parameter falls on the page of a picture of this input.
report::Vec2 place_in_plane(const PictureInput& input, double u, double v, PictureOptions options = {}) {
  const report::Content content = report::prepare(input, 40);
  report::Canvas canvas(report::Format::png, options.width, options.height);
  const report::Layout l = report::lay_out(canvas, content);
  const report::Box b = report::draw_parameter_plane(canvas, content, l.plane, l.em, l.full);
  return {b.x + u * b.width, b.bottom() - v * b.height};
}

std::string message_of(const PictureInput& input, const std::string& extension, PictureOptions options = {}) {
  try {
    draw_picture(input, extension, options);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

PictureInput input_of(const Surface& surface, const ParameterizedPoints* points = nullptr,
                      std::vector<double> errors = {}, double tolerance = 0) {
  PictureInput input;
  input.surface = &surface;
  input.points = points;
  input.signed_errors = std::move(errors);
  input.tolerance = tolerance;
  return input;
}

class PictureOfHills : public testing::Test {
 protected:
  Surface surface = scenes::heights(scenes::hills);
  ParameterizedPoints points = scenes::random_points(2000);
  PictureInput input;
  PictureOfHills() {
    points.values.clear();
    input.surface = &surface;
    input.points = &points;
    for (Index k = 0; k < points.size(); ++k)
      input.signed_errors.push_back(1e-3 * std::sin(9 * points.u(k)) * std::cos(7 * points.v(k)));
    input.tolerance = 5e-4;
    input.title = "hills";
    input.thin_places = {{.u = 0.4, .v = 0.4}, {.u = 0.43, .v = 0.41}};
  }
};

TEST_F(PictureOfHills, HasTheSizeAskedForInEveryFormat) {
  const std::string png = draw_picture(input, ".png", {640, 360});
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const Pixels pixels = decode(png);
  EXPECT_EQ(pixels.width, 640);
  EXPECT_EQ(pixels.height, 360);
  const std::string svg = draw_picture(input, ".svg", {640, 360});
  EXPECT_EQ(svg.substr(0, 5), "<?xml");
  EXPECT_NE(svg.find("viewBox=\"0 0 640 360\""), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const std::string pdf = draw_picture(input, ".pdf", {640, 360});
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("/MediaBox [ 0 0 640 360 ]"), std::string::npos);
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
}

TEST_F(PictureOfHills, HasTheSameBytesEveryTimeForAnyNumberOfThreads) {
  for (const char* extension : {".png", ".svg", ".pdf"}) {
    set_thread_count(1);
    const std::string one = draw_picture(input, extension, {800, 450});
    set_thread_count(2);
    EXPECT_TRUE(draw_picture(input, extension, {800, 450}) == one) << extension;
    EXPECT_TRUE(draw_picture(input, extension, {800, 450}) == one) << extension;
    set_thread_count(0);
  }
}

TEST_F(PictureOfHills, CarriesNoDate) {
  const std::string pdf = draw_picture(input, ".pdf", {640, 360});
  EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
  EXPECT_EQ(pdf.find("ModDate"), std::string::npos);
}

TEST_F(PictureOfHills, ShowsTheThinPlaces) {
  PictureInput without = input;
  without.thin_places.clear();
  const Pixels a = decode(draw_picture(input, ".png", {800, 450})),
               b = decode(draw_picture(without, ".png", {800, 450}));
  const report::Vec2 at = place_in_plane(input, 0.415, 0.405, {800, 450});
  int changed = 0;
  for (int dy = -6; dy <= 6; ++dy)
    for (int dx = -6; dx <= 6; ++dx) changed += a.at(at.x + dx, at.y + dy) != b.at(at.x + dx, at.y + dy);
  EXPECT_GT(changed, 20);
}

TEST_F(PictureOfHills, ShowsOpeningsGreyAndHatched) {
  PictureInput bare = input_of(surface);
  bare.openings = {{0.55, 0.55, 0.85, 0.55, 0.85, 0.85}, {0.55, 0.55, 0.85, 0.85, 0.55, 0.85}};
  const Pixels a = decode(draw_picture(bare, ".png", {800, 450}));
  int grey = 0, pale = 0;
  const report::Vec2 at = place_in_plane(bare, 0.7, 0.7, {800, 450});
  for (int dy = -8; dy <= 8; ++dy)
    for (int dx = -8; dx <= 8; ++dx) {
      const std::uint32_t pixel = a.at(at.x + dx, at.y + dy);
      const int red = channel(pixel, 0), blue = channel(pixel, 2);
      grey += std::abs(red - 184) < 6 && std::abs(blue - 186) < 6;
      pale += red > 215 && std::abs(red - blue) < 6;
    }
  EXPECT_GT(grey, 50);
  EXPECT_GT(pale, 20);
  const report::Content content = report::prepare(bare, 40);
  EXPECT_TRUE(content.gaps);
  EXPECT_FALSE(content.colour_at(0.7, 0.7, 0));
  EXPECT_TRUE(content.colour_at(0.3, 0.7, 0));
  bare.openings[0][3] = NAN;
  EXPECT_NE(message_of(bare, ".png").find("not finite"), std::string::npos);
}

TEST_F(PictureOfHills, RefusesWhatItCannotDraw) {
  EXPECT_NE(message_of(input, ".gif").find("\".gif\""), std::string::npos);
  EXPECT_NE(message_of(input, ".gif").find(".png, .svg and .pdf"), std::string::npos);
  EXPECT_NE(message_of(input, "png").find("no extension"), std::string::npos);
  for (int size : {199, 20001, 0, -5}) {
    EXPECT_NE(message_of(input, ".png", {size, 900}).find("width of " + std::to_string(size)),
              std::string::npos);
    EXPECT_NE(message_of(input, ".png", {900, size}).find("height of " + std::to_string(size)),
              std::string::npos);
  }
  PictureInput none;
  EXPECT_NE(message_of(none, ".png").find("needs a surface"), std::string::npos);
  PictureInput few = input;
  few.signed_errors.resize(3);
  EXPECT_NE(message_of(few, ".png").find("3 errors for 2000 points"), std::string::npos);
  PictureInput nan = input;
  nan.signed_errors[17] = NAN;
  EXPECT_NE(message_of(nan, ".png").find("point 17"), std::string::npos);
  PictureInput tolerance = input;
  tolerance.tolerance = -1;
  EXPECT_NE(message_of(tolerance, ".png").find("tolerance"), std::string::npos);
  PictureInput flat = input;
  const Surface plane = scenes::in_space([](double u, double v) { return std::vector{u, v}; });
  flat.surface = &plane;
  EXPECT_NE(message_of(flat, ".png").find("dimension 2"), std::string::npos);
  points.map.u1 = points.map.u0;
  EXPECT_NE(message_of(input, ".png").find("parameter map"), std::string::npos);
}

// One point a square of the plane, large discs of known colour.
TEST(PictureColours, AreThoseOfTheErrorsInTheParameterPlane) {
  const Surface s = scenes::heights([](double u, double v) { return u * v; }, 0);
  ParameterizedPoints points;
  points.uv = {0.25, 0.25, 0.75, 0.25, 0.25, 0.75, 0.75, 0.75};
  const PictureInput input = input_of(s, &points, {2.0, -2.0, 0.0, 1e-9}, 1);
  const Pixels p = decode(draw_picture(input, ".png"));
  auto at = [&](double u, double v) {
    const report::Vec2 q = place_in_plane(input, u, v);
    return p.at(q.x, q.y);
  };
  expect_colour(at(0.25, 0.25), report::diverging(1));
  expect_colour(at(0.75, 0.25), report::diverging(-1));
  expect_colour(at(0.25, 0.75), report::diverging(0));
  expect_colour(at(0.75, 0.75), report::diverging(0));
  expect_colour(at(0.5, 0.5), {1, 1, 1});
}

TEST(PictureColours, ShowTheWorstErrorAmongMillionsOfPoints) {
  const Surface s = scenes::heights([](double u, double v) { return u * v; }, 0);
  ParameterizedPoints points = scenes::random_points(1000000);
  points.values.clear();
  PictureInput input = input_of(s, &points);
  input.signed_errors.assign(1000000, 0.1);
  input.signed_errors[123456] = -5;
  input.tolerance = 1;
  points.uv[2 * 654321] = points.uv[2 * 123456] + 0.004;  // a second one, not covered by the worst's ring
  points.uv[2 * 654321 + 1] = points.uv[2 * 123456 + 1] + 0.1;
  input.signed_errors[654321] = 4;
  const Pixels p = decode(draw_picture(input, ".png"));
  const report::Vec2 q = place_in_plane(input, points.u(654321), points.v(654321));
  bool found = false;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint32_t pixel = p.at(q.x + dx, q.y + dy);
      found |= channel(pixel, 0) > channel(pixel, 2) + 40;
    }
  EXPECT_TRUE(found) << "the orange of the second worst point";
}

TEST(PictureColours, AreNeutralOnASurfaceWithoutErrors) {
  const Surface s = scenes::heights([](double u, double v) { return 0.2 * u + 0.1 * v; }, 0);
  ParameterizedPoints points = scenes::random_points(3000);
  points.values.clear();
  const PictureInput input = input_of(s, &points, std::vector<double>(3000, 0.0), 1);
  const Pixels p = decode(draw_picture(input, ".png"));
  report::Canvas canvas(report::Format::png, 1600, 900);
  const report::Layout l = report::lay_out(canvas, report::prepare(input, 40));
  const std::uint32_t centre = p.at(l.surface.centre().x, l.surface.centre().y);
  EXPECT_LE(std::abs(channel(centre, 0) - channel(centre, 2)), 2);
  EXPECT_LE(std::abs(channel(centre, 0) - channel(centre, 1)), 2);
  EXPECT_GT(channel(centre, 0), 120);
  EXPECT_LT(channel(centre, 0), 250) << "the surface is there";
}

TEST(PictureColours, FollowTheErrorsOnTheSurface) {
  const Surface s = scenes::heights([](double, double) { return 1.0; }, 0);
  ParameterizedPoints points = scenes::random_points(3000);
  points.values.clear();
  PictureInput input = input_of(s, &points, {}, 1);
  report::Canvas canvas(report::Format::png, 1600, 900);
  for (double sign : {1.0, -1.0}) {
    input.signed_errors.assign(3000, sign * 3);
    input.signed_errors[0] = -sign;  // not one-sided
    const report::Layout l = report::lay_out(canvas, report::prepare(input, 40));
    const Pixels p = decode(draw_picture(input, ".png"));
    const std::uint32_t centre = p.at(l.surface.centre().x, l.surface.centre().y);
    EXPECT_GT(sign * (channel(centre, 0) - channel(centre, 2)), 40);
  }
}

TEST(Picture, DrawsDegenerateSurfacesAndStrangeTexts) {
  std::vector<Surface> surfaces;
  surfaces.push_back(scenes::heights([](double, double) { return 5.0; }));
  surfaces.push_back(scenes::heights([](double, double) { return 0.0; }));
  surfaces.push_back(scenes::heights([](double u, double v) { return 1e8 + 1e-3 * u * v; }));
  surfaces.push_back(scenes::heights([](double u, double v) { return 1e-300 * u * v; }));
  surfaces.push_back(scenes::heights([](double u, double v) { return 1e300 * u * v; }));
  for (double size : {0.0, 1e-200, 1e8, 1e150})
    surfaces.push_back(scenes::in_space([&](double u, double v) {
      return std::vector{size * (u + 0.1 * v), size * v, size * u * u};
    }));
  surfaces.push_back(scenes::in_space([](double u, double) {
    return std::vector{u, 2 * u, 3 * u};
  }));  // a line
  surfaces.push_back(scenes::in_space([](double u, double v) { return std::vector{1e8 + u, 1e8 + v, 1e8}; }));
  surfaces.push_back(scenes::in_space([](double u, double v) {
    return std::vector{u, v + u, u * v, 7.0, 8.0};
  }));
  for (const Surface& s : surfaces) {
    PictureInput input = input_of(s);
    input.title = "bad \xFF\n text";
    input.subtitle = std::string(5000, 'x');
    for (const char* extension : {".png", ".svg", ".pdf"}) {
      const std::string bytes = draw_picture(input, extension, {300, 220});
      EXPECT_GT(bytes.size(), 1000u);
      EXPECT_TRUE(extension != std::string(".svg") || bytes.find("nan") == std::string::npos);
    }
  }
}

TEST(Picture, DrawsSurfacesOnADomainOfTheirOwnAndEveryDegree) {
  for (int degree : {1, 2, 5, 9}) {
    const KnotVector u = KnotVector::uniform(degree, 2, 10, 20), v = KnotVector::uniform(degree, 1, -3, -1);
    std::vector<double> net;
    for (double a : u.greville())
      for (double b : v.greville()) net.push_back(std::sin(a) * b);
    const Surface s(u, v, 1, net);
    const PictureInput input = input_of(s);
    EXPECT_GT(draw_picture(input, ".png", {400, 300}).size(), 1000u);
  }
}

}  // namespace
}  // namespace knotfit
