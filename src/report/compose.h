// All parts of a picture on one page.
#pragma once
#include <string>

#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

/// A panel's heading, and a remark beside it where there is room.
void draw_heading(Canvas& canvas, const Box& box, const std::string& heading, const std::string& remark,
                  double em);

void draw(Canvas& canvas, const Content& content);

}  // namespace knotfit::report
