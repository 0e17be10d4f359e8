#include "pixels.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstring>
namespace knotfit {

Pixels decode(const std::string& png) {
  struct Reader {
    const std::string& bytes;
    std::size_t at;
  } reader{png, 0};
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(
      [](void* closure, unsigned char* out, unsigned int length) {
        Reader& r = *static_cast<Reader*>(closure);
        if (r.at + length > r.bytes.size()) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(out, r.bytes.data() + r.at, length);
        r.at += length;
        return CAIRO_STATUS_SUCCESS;
      },
      &reader);
  EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  Pixels p{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  for (int y = 0; y < p.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface) +
                                                             y * cairo_image_surface_get_stride(surface));
    for (int x = 0; x < p.width; ++x) p.rgb.push_back(row[x] & 0xFFFFFF);
  }
  cairo_surface_destroy(surface);
  return p;
}

}  // namespace knotfit
