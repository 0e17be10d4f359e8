// Images whose pixels are means of finer ones.
#pragma once
#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "report/canvas.h"
#include "report/colour_map.h"
namespace knotfit::report {

/// \param finer  fine pixels a pixel, each way
/// \param pixel  colour of the fine pixel (x, y), none: clear; called from any thread
template <class Pixel>
Image averaged_pixels(int width, int height, int finer, const Pixel& pixel) {
  Image image(width, height);
  parallel_for(image.height, [&](Index row) {
    for (int column = 0; column < image.width; ++column) {
      Rgb sum;
      int hits = 0;
      for (int dy = 0; dy < finer; ++dy)
        for (int dx = 0; dx < finer; ++dx)
          if (const std::optional<Rgb> c = pixel(column * finer + dx, static_cast<int>(row) * finer + dy)) {
            sum = {sum.r + c->r, sum.g + c->g, sum.b + c->b};
            ++hits;
          }
      if (hits > 0)
        image.at(column, static_cast<int>(row)) = premultiplied({sum.r / hits, sum.g / hits, sum.b / hits},
                                                                static_cast<double>(hits) / (finer * finer));
    }
  });
  return image;
}

}  // namespace knotfit::report
