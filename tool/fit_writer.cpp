#include "fit_writer.h"

#include <filesystem>
#include <limits>

#include "cad_output.h"
#include "fit_run.h"
#include "knotfit/exceptions.h"
#include "knotfit/grid_support.h"
#include "mesh_outputs.h"
#include "options_json.h"
#include "sampling.h"
namespace knotfit::tool {
namespace {

/// \param support  of scattered points: 0 where they leave a node without data; empty: all nodes have heights
Raster fitted_heights(Raster grid, const FitResult& result, const FitInput& input, const FitChoices& c,
                      const std::vector<char>& support) {
  fill_heights(grid, result.surface, result.map);
  if (input.raster && !*c.fill_holes) keep_holes(grid, *input.raster);
  for (std::size_t k = 0; k < support.size(); ++k)
    if (support[k] == 0) grid.z[k] = std::numeric_limits<double>::quiet_NaN();
  return grid;
}

// Corrected parameters, the distance, the same signed by the normal, the error at the parameters, and where on the surface
// the distance is.
Table corrected_residuals(const MeshFit& fit, const MappedMesh& mapped) {
  std::vector<double> columns[10];
  const std::vector<double> at_parameters = recheck_errors(fit.result.surface, fit.points);
  for (Index k = 0; k < fit.points.size(); ++k) {
    for (int c = 0; c < 3; ++c) columns[c].push_back(fit.points.value(k)[c]);
    columns[3].push_back(fit.points.u(k));
    columns[4].push_back(fit.points.v(k));
    columns[5].push_back(fit.result.errors[k]);
    columns[6].push_back(fit.signed_distances[k]);
    columns[7].push_back(at_parameters[k]);
    for (int c = 0; c < 2; ++c) columns[8 + c].push_back(fit.foot_uv[2 * k + c]);
  }
  for (std::size_t k = 0; k < mapped.loose_distance.size();
       ++k) {  // points that no triangle has, at their feet
    for (int c = 0; c < 3; ++c) columns[c].push_back(mapped.loose[3 * k + c]);
    for (int c = 5; c < 8; ++c) columns[c].push_back(mapped.loose_distance[k]);
    for (int c = 0; c < 2; ++c) {
      columns[3 + c].push_back(mapped.loose_uv[2 * k + c]);
      columns[8 + c].push_back(mapped.loose_uv[2 * k + c]);
    }
  }
  Table table;
  const char* names[] = {"x",      "y",     "z", "u", "v", "error", "distance", "error_at_parameters",
                         "foot_u", "foot_v"};
  for (int c = 0; c < 10; ++c) table.add(names[c], std::move(columns[c]));
  return table;
}

}  // namespace

Raster output_grid(const FitInput& input, const FitChoices& c) {
  if (!input.points.height_field)
    throw InvalidInput("an .asc output holds heights over x, y: use --height-field, or leave it out");
  if (c.cell) return grid_over(input.points.map, *c.cell);
  if (!input.raster) throw InvalidInput("an .asc output of scattered points needs --cell SIZE");
  Raster grid = *input.raster;
  grid.z.clear();
  return grid;
}

std::vector<char> output_support(const Raster& grid, const FitInput& input, const FitResult& result,
                                 const FitChoices& choices) {
  if (grid.rows == 0 || input.raster || *choices.fill_holes || result.surface.empty()) return {};
  return grid_support(input.points, grid);
}

std::string FitWriter::surface_json() const {
  const FitResult& result = report_.result;
  return to_json({.surface = result.surface,
                  .map = result.map,
                  .height_field = result.height_field,
                  .options = options_to_json(report_.choices),
                  .result = stored_result(report_)});
}

std::string FitWriter::draw(const std::string& extension, const PictureOptions& options) const {
  return draw_picture(picture(), extension, options);
}

void FitWriter::write(const OutputFile& file) const {
  const FitResult& result = report_.result;
  const FitInput& input = report_.input;
  switch (file.kind) {
    case OutputKind::surface:
      return write_text_file(file.path, force_, surface_json());
    case OutputKind::table: {
      if (report_.corrected != nullptr)
        return write_text_file(file.path, force_,
                               to_csv(corrected_residuals(*report_.corrected, *input.mesh)));
      const std::vector<double> errors = errors_of_all(result, input);
      return write_file(file.path, force_,
                        [&](std::ostream& out) { write_residuals(out, points_of_all(input), errors); });
    }
    case OutputKind::raster:
      return write_raster_file(file.path, force_,
                               fitted_heights(grid_, result, input, report_.choices, support_));
    case OutputKind::mesh:
      return write_surface_mesh(file, force_, result.surface, result.map, result.height_field,
                                *report_.choices.samples, &input.points, result.errors);
    case OutputKind::cad:
      return write_cad_file(file, force_, result.surface, result.map, result.height_field,
                            report_.choices.cad);
    case OutputKind::picture:
      return write_text_file(file.path, force_, draw(file.extension));
  }
}

PictureInput FitWriter::picture() const {
  const FitResult& result = report_.result;
  PictureInput p;
  p.surface = &result.surface;
  p.points = &report_.input.points;
  if (report_.corrected != nullptr) {
    // Errors are distances: drawn where on the surface they are.
    feet_ = report_.input.points;
    feet_.uv = report_.corrected->foot_uv;
    p.points = &feet_;
    for (const double d : report_.corrected->signed_distances) p.signed_errors.push_back(-d);  // S - P
    p.fold_places = report_.corrected->correction.folds.places;
  } else {
    p.signed_errors = signed_errors(result.surface, report_.input.points);
  }
  p.tolerance = result.tolerance;
  p.title = std::filesystem::path(report_.input.summary.path).filename().string() + ", " + verdict(report_);
  p.subtitle = report_.call.empty() ? "knotfit fit " + options_to_text(report_.choices) : report_.call;
  p.thin_places = result.between.thin_places;
  if (const auto& mapped = report_.input.mesh; mapped && !parameters_of(*mapped).empty()) {
    const std::vector<double>& uv = report_.corrected != nullptr && !report_.corrected->correction.uv.empty()
                                        ? report_.corrected->correction.uv
                                        : parameters_of(*mapped);
    for (const Opening& o : mapped->openings)
      for (const std::int32_t f : o.faces) {
        const auto& t = mapped->mesh.faces[f];
        p.openings.push_back(
            {uv[2 * t[0]], uv[2 * t[0] + 1], uv[2 * t[1]], uv[2 * t[1] + 1], uv[2 * t[2]], uv[2 * t[2] + 1]});
      }
  }
  p.reflections = reflections_;
  return p;
}

}  // namespace knotfit::tool
