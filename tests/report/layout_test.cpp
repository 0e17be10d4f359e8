#include "report/layout.h"

#include <gtest/gtest.h>

#include "crowded.h"
#include "report/compose.h"
namespace knotfit::report {
namespace {

TEST(Layout, KeepsItsPartsApartAndOnThePage) {
  for (int dimension : {1, 3}) {
    Case c;
    fill(c, dimension);
    const Content content = prepare(c.input, 60);
    for (auto [width, height] : kSizes) {
      const Canvas canvas(Format::svg, width, height);
      const Layout l = lay_out(canvas, content);
      const Box page{0, 0, static_cast<double>(width), static_cast<double>(height)};
      std::vector<Box> parts;
      for (const Box& b : {l.title, l.subtitle_box, l.surface_heading, l.surface, l.plane_heading, l.plane,
                           l.legend, l.facts})
        if (b.width > 0) parts.push_back(b);
      ASSERT_GT(l.surface.width, 0);
      for (std::size_t a = 0; a < parts.size(); ++a) {
        EXPECT_TRUE(page.contains(parts[a], 0.5)) << width << " x " << height << ", part " << a;
        for (std::size_t b = 0; b < a; ++b)
          EXPECT_FALSE(parts[a].overlaps(
              {parts[b].x + 0.5, parts[b].y + 0.5, parts[b].width - 1, parts[b].height - 1}))
              << width << " x " << height << ", parts " << b << " and " << a;
      }
    }
  }
}

TEST(Layout, GivesTheSurfaceItsShareOfThePage) {
  Case c;
  fill(c, 1);
  const Content content = prepare(c.input, 60);
  for (auto [width, height] : {std::pair{1600, 900}, {800, 450}, {1000, 1000}}) {
    const Canvas canvas(Format::svg, width, height);
    const Layout l = lay_out(canvas, content);
    EXPECT_GT(l.surface.width * l.surface.height, 0.22 * width * height) << width << " x " << height;
    EXPECT_GT(l.plane.width, 0.25 * width);
  }
}

}  // namespace
}  // namespace knotfit::report
