#include "curve_options.h"
namespace knotfit::tool {
namespace {

constexpr int kCorrections = 20;

}  // namespace

CurveFitOptions curve_options(const Arguments& arguments) {
  const FitChoices& c = arguments.choices;
  CurveFitOptions options;
  if (c.control_points) options.control_points = c.control_points->first;
  options.knots = arguments.knots_t;
  // Of a closed curve the seam is a knot of its own.
  if (options.knots && arguments.closed) options.knots->insert(options.knots->begin(), 0.0);
  if (c.tolerance || (options.control_points == 0 && !options.knots)) {
    const ToleranceValue t = c.tolerance.value_or(kDefaultTolerance);
    const MeasureValue m = c.measure.value_or(MeasureValue{});
    options.tolerance =
        ToleranceRequest{.value = t.value, .relative = t.relative, .measure = m.measure, .share = m.share};
  }
  if (c.knots) options.method = c.knots->method;
  if (c.degree) options.degree = c.degree->first;
  options.corrections = arguments.corrected ? kCorrections : 0;
  options.max_control_points = static_cast<Index>(c.max_control_points.value_or(0));
  options.max_fits = c.max_fits.value_or(0);
  options.smoothing = c.smoothing.value_or(options.smoothing);
  options.feature = c.feature.value_or(options.feature);
  options.evaluations = c.evaluations.value_or(options.evaluations);
  return options;
}

}  // namespace knotfit::tool
