// All parts of a picture on one page.
#pragma once
#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

void draw(Canvas& canvas, const Content& content);

}  // namespace knotfit::report
