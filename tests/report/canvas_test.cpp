#include "report/canvas.h"

#include <gtest/gtest.h>
namespace knotfit::report {
namespace {

TEST(Printable, KeepsValidTextAndReplacesTheRest) {
  EXPECT_EQ(printable("Größe − 10⁻³ 面 😀"), "Größe − 10⁻³ 面 😀");
  EXPECT_EQ(printable("a\nb\tc\x7F"), "a b c ");
  EXPECT_EQ(printable("\xFFx"), "?x");
  EXPECT_EQ(printable("\xC3"), "?");                 // cut short
  EXPECT_EQ(printable("\xC0\xAF"), "??");            // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");       // surrogate
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");  // beyond Unicode
}

TEST(CanvasText, ShortensToTheWidthAtCharacters) {
  const Canvas canvas(Format::png, 200, 200);
  const std::string text = "größere Flächen über 面面面 hinaus";
  EXPECT_EQ(canvas.shortened(text, 1e4, 12), text);
  for (double width : {20.0, 50.0, 90.0, 130.0}) {
    const std::string cut = canvas.shortened(text, width, 12);
    EXPECT_LE(canvas.text_width(cut, 12), width);
    EXPECT_TRUE(cut.ends_with("…"));
    EXPECT_EQ(printable(cut), cut);
  }
  EXPECT_EQ(canvas.shortened(text, 1, 12), "");
}

TEST(CanvasText, WrapsAtSpacesAndShortensTheLastLine) {
  const Canvas canvas(Format::png, 200, 200);
  const auto lines = canvas.wrapped("one two three four five six seven eight nine ten", 80, 12, 3);
  ASSERT_EQ(lines.size(), 3u);
  for (const std::string& line : lines) EXPECT_LE(canvas.text_width(line, 12), 80);
  EXPECT_TRUE(lines[2].ends_with("…"));
  EXPECT_EQ(canvas.wrapped("short", 80, 12, 3).size(), 1u);
  EXPECT_TRUE(canvas.wrapped("", 80, 12, 3).empty());
}

TEST(Canvas, GivesTheSameSvgWhateverWasDrawnBefore) {
  auto draw = [] {
    Canvas canvas(Format::svg, 300, 200);
    Image image(4, 4);
    for (auto& p : image.pixels) p = premultiplied({0.2, 0.4, 0.6}, 0.5);
    canvas.image({10, 10, 50, 50}, image);
    canvas.text({10, 100}, "text", {});
    return canvas.finish();
  };
  const std::string first = draw();
  EXPECT_EQ(draw(), first);
  EXPECT_EQ(draw(), first);
}

TEST(Premultiplied, ScalesColoursByAlpha) {
  EXPECT_EQ(premultiplied({1, 0, 0.5}), 0xFFFF0080u);
  EXPECT_EQ(premultiplied({1, 1, 1}, 0), 0u);
  EXPECT_EQ(premultiplied({1, 0, 0}, 0.5), 0x80800000u);
}

}  // namespace
}  // namespace knotfit::report
