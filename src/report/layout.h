// Where the parts of a picture stand, for any size and aspect.
#pragma once
#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

struct Layout {
  double em = 17;        ///< size of body text
  bool axes = true;      ///< ticks and names at the panels
  bool headings = true;  ///< over the panels
  Box title, surface_heading, surface, plane_heading, plane, legend, facts;  ///< zero: left out
  std::vector<std::string> subtitle;                                         ///< in lines
};

Layout lay_out(const Canvas& canvas, const Content& content);

}  // namespace knotfit::report
