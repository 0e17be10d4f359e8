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

Layout lay_out(const Canvas& canvas, const Content& content);

}  // namespace knotfit::report
