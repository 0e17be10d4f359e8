// The left panel: the surface in perspective with its knot lines.
#pragma once
#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

/// \param em    size of body text
/// \param axes  axes with ticks around a height field, a triad beside other surfaces
/// \return a sentence on how it is drawn (view, exaggeration), for the panel's caption
std::string draw_surface_view(Canvas& canvas, const Content& content, const Box& panel, double em, bool axes);

}  // namespace knotfit::report
