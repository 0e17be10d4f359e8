// Where the parts of a picture stand, for any size and aspect.
#pragma once
#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

struct Layout {
  double em = 17;                     ///< size of body text
  bool full = true;                   ///< with headings, axes and figures; false on small pages
  std::vector<std::string> subtitle;  ///< in lines
  /// Zero width: left out.
  Box title, subtitle_box, surface_heading, surface, plane_heading, plane, legend, facts;
};

/// Size of body text: it grows more slowly than the page, so that small pictures stay legible and large
/// ones do not shout.
double body_size(double width, double height);
/// Whether a page has room for more than one drawing.
bool full_page(double width, double height, double em);

Layout lay_out(const Canvas& canvas, const Content& content);

}  // namespace knotfit::report
