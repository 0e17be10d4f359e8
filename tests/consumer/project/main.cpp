// Fits a small height field and uses one function of every part that needs another library.
#include <knotfit/evaluate.h>
#include <knotfit/fit_surface.h>
#include <knotfit/io.h>
#include <knotfit/picture.h>
#include <knotfit/version.h>

#include <cmath>
#include <cstdio>

int main() {
  knotfit::ParameterizedPoints points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const double u = i / 19.0, v = j / 19.0;
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(std::sin(3 * u) * std::cos(2 * v));
    }
  knotfit::FitOptions options;
  options.control_points_u = options.control_points_v = 8;
  options.method = "uniform";
  const knotfit::FitResult result = knotfit::fit_surface(points, options);

  double value = 0;
  knotfit::evaluate(result.surface, 0.5, 0.5, {&value, 1});
  const double difference = std::abs(value - std::sin(1.5) * std::cos(1.0));
  knotfit::SurfaceDocument document;
  document.surface = result.surface;
  const std::string json = knotfit::to_json(document);
  knotfit::PictureInput picture;
  picture.surface = &result.surface;
  picture.points = &points;
  const std::string svg = knotfit::draw_picture(picture, ".svg");
  std::printf("knotfit %s: error %g, %zu bytes of JSON, %zu of SVG\n",
              std::string(knotfit::version()).c_str(), difference, json.size(), svg.size());
  // Five cubic spans: an interpolant errs by at most 0.2^4/384 max|f''''| = 3.4e-4 (max|f''''| = 81),
  // the least squares surface by a small multiple of that.
  return difference < 1e-3 && !json.empty() && !svg.empty() ? 0 : 1;
}
