#include "report/compose.h"

#include <array>

#include "report/layout.h"
#include "report/legend.h"
#include "report/parameter_plane.h"
#include "report/surface_view.h"
namespace knotfit::report {
void draw_heading(Canvas& canvas, const Box& box, const std::string& heading, const std::string& remark,
                  double em) {
  const double size = 0.95 * em, quiet = 0.8 * em, gap = 0.9 * em;
  const std::string shown = canvas.shortened(heading, box.width, size, true);
  canvas.text({box.x, box.y + em}, shown, {.size = size, .bold = true, .paint = {kInk}});
  const double used = canvas.text_width(shown, size, true) + gap;
  if (remark.empty() || box.width - used < 6 * em) return;
  canvas.text({box.x + used, box.y + em}, canvas.shortened(remark, box.width - used, quiet),
              {.size = quiet, .paint = {kQuiet}});
}

void draw(Canvas& canvas, const Content& content) {
  const PictureInput& input = *content.input;
  const Layout l = lay_out(canvas, content);
  const double em = l.em;

  const std::string drawn = draw_surface_view(canvas, content, l.surface, em, l.full);
  if (l.plane.width > 0) draw_parameter_plane(canvas, content, l.plane, em, l.full);
  if (l.legend.width > 0) draw_legend(canvas, content, l.legend, em);
  if (!input.title.empty())
    canvas.text({l.title.x, l.title.y}, canvas.shortened(input.title, l.title.width, 1.4 * em, true),
                {.size = 1.4 * em, .bold = true, .paint = {kInk}, .vertical = Align::end});
  for (std::size_t k = 0; k < l.subtitle.size(); ++k)
    canvas.text({l.subtitle_box.x, l.subtitle_box.y + 1.35 * em * static_cast<double>(k)}, l.subtitle[k],
                {.size = 0.95 * em, .paint = {kQuiet}, .vertical = Align::end});
  if (l.full) {
    draw_heading(canvas, l.surface_heading, "Surface and its knot lines", drawn, em);
    const char* what = content.point_count == 0 ? (content.colouring == Colouring::height ? "heights" : "")
                       : content.colouring == Colouring::error ? "points by their error"
                                                               : "points";
    draw_heading(canvas, l.plane_heading, "Parameter plane", what, em);
  }
  if (l.facts.width > 0) {
    const std::array<Vec2, 2> rule{Vec2{l.facts.x, l.facts.y - 0.8 * em},
                                   Vec2{l.facts.right(), l.facts.y - 0.8 * em}};
    canvas.segments(rule, em / 17, {kQuiet, 0.45});
    draw_facts(canvas, facts_of(content), l.facts, em);
  }
}

}  // namespace knotfit::report
