#include "knotfit/picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/errors.h"
#include "report/compose.h"
namespace knotfit {
namespace {

using namespace report;

Format format_of(const std::string& extension) {
  if (extension == ".png") return Format::png;
  if (extension == ".svg") return Format::svg;
  if (extension == ".pdf") return Format::pdf;
  throw InvalidInput(fmt::format("\"{}\" is no extension of a picture: .png, .svg and .pdf are", extension));
}

void check_size(const char* name, int size) {
  if (size < 200 || size > 20000)
    throw InvalidInput(fmt::format("a picture's {} of {} is outside 200 to 20000", name, size));
}

}  // namespace

std::string draw_picture(const PictureInput& input, const std::string& extension,
                         const PictureOptions& options) {
  const Format format = format_of(extension);
  check_size("width", options.width);
  check_size("height", options.height);
  const int most = std::clamp(static_cast<int>(0.4 * std::max(options.width, options.height)), 120, 600);
  const Content content = prepare(input, most);
  Canvas canvas(format, options.width, options.height);
  canvas.document_title(input.title);
  draw(canvas, content);
  return canvas.finish();
}

}  // namespace knotfit
