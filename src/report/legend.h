// What the colours and marks mean.
#pragma once
#include <utility>
#include <vector>

#include "report/canvas.h"
#include "report/content.h"
namespace knotfit::report {

/// Height that draw_legend needs at this width.
double legend_height(const Canvas& canvas, const Content& content, double width, double em);
/// Colour bar with ticks and the tolerance band, then the marks that the picture uses.
void draw_legend(Canvas& canvas, const Content& content, const Box& box, double em);

/// The figures under the picture, a name and a value each.
using Facts = std::vector<std::pair<std::string, std::string>>;
Facts facts_of(const Content& content);
double facts_height(const Canvas& canvas, const Facts& facts, double width, double em);
void draw_facts(Canvas& canvas, const Facts& facts, const Box& box, double em);

}  // namespace knotfit::report
