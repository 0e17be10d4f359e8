#include "report/compose.h"

#include <gtest/gtest.h>

#include "crowded.h"
#include "report/layout.h"
namespace knotfit::report {
namespace {

TEST(Picture, HasNoTextOnText) {
  for (int dimension : {1, 3}) {
    Case c;
    fill(c, dimension);
    for (bool errors : {true, false}) {
      if (!errors) c.input.signed_errors.clear();
      const Content content = prepare(c.input, 60);
      for (auto [width, height] : kSizes) {
        Canvas canvas(Format::png, width, height);
        draw(canvas, content);
        const std::vector<Box>& texts = canvas.text_boxes();
        const Box page{0, 0, static_cast<double>(width), static_cast<double>(height)};
        for (std::size_t a = 0; a < texts.size(); ++a) {
          EXPECT_TRUE(page.contains(texts[a], 1)) << width << " x " << height << ": a text leaves the page";
          for (std::size_t b = 0; b < a; ++b)
            EXPECT_FALSE(texts[a].overlaps(texts[b]))
                << width << " x " << height << " dimension " << dimension << ": texts at " << texts[a].x
                << "," << texts[a].y << " and " << texts[b].x << "," << texts[b].y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace knotfit::report
