// What stands around the surface in its panel: axes of height fields, a triad, the worst point.
#pragma once
#include <string>

#include "report/camera.h"
#include "report/canvas.h"
#include "report/surface_samples.h"
namespace knotfit::report {

/// Lines behind a height field: the far edges of its base and the axis of heights.
void draw_back_frame(Canvas& canvas, const SurfaceSamples& samples, const Camera& camera, double base,
                     double em);
/// The near edges of the base with ticks and names, and the ticks of the heights.
/// \param unit  of heights, or empty
void draw_frame(Canvas& canvas, const SurfaceSamples& samples, const Camera& camera, double base, double em,
                const std::string& unit);
/// Directions of x, y, z about a point of the page.
void draw_triad(Canvas& canvas, const Camera& camera, Vec2 at, double em);
/// The ring that marks the worst point, here and in the parameter plane.
void draw_worst_mark(Canvas& canvas, Vec2 at, double em);
/// Where the surface folds. \param radius  at least that of a mark in the legend is drawn
void draw_fold_mark(Canvas& canvas, Vec2 at, double radius, double em);

}  // namespace knotfit::report
