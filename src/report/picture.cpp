#include "knotfit/picture.h"

#include <algorithm>

#include "report/compose.h"
namespace knotfit {

using namespace report;

std::string draw_picture(const PictureInput& input, const std::string& extension,
                         const PictureOptions& options) {
  const Format format = picture_format(extension);
  check_page(options.width, options.height);
  const int most = std::clamp(static_cast<int>(0.4 * std::max(options.width, options.height)), 120, 600);
  const Content content = prepare(input, most);
  Canvas canvas(format, options.width, options.height);
  canvas.document_title(input.title);
  draw(canvas, content);
  return canvas.finish();
}

}  // namespace knotfit
