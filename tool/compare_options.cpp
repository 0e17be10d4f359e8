#include "compare_options.h"

#include <tuple>
namespace knotfit::tool {

CompareOptions compare_options(const Arguments& arguments) {
  const FitChoices& c = arguments.choices;
  CompareOptions options;
  if (!arguments.methods.empty()) options.methods = arguments.methods;
  for (const IntegerPair& size : arguments.sizes) options.sizes.push_back({size.first, size.second});
  const MeasureValue measure = c.measure.value_or(MeasureValue{});
  for (const ToleranceValue& t : arguments.tolerances)
    options.tolerances.push_back(
        {.value = t.value, .relative = t.relative, .measure = measure.measure, .share = measure.share});
  FitOptions& fit = options.fit;
  if (c.degree) std::tie(fit.degree_u, fit.degree_v) = std::pair{c.degree->first, c.degree->second};
  fit.max_control_points = static_cast<Index>(c.max_control_points.value_or(0));
  fit.max_fits = c.max_fits.value_or(fit.max_fits);
  fit.smoothing = c.smoothing.value_or(fit.smoothing);
  fit.feature = c.feature.value_or(fit.feature);
  if (c.feature_file) fit.user_features = {.size_u = 1, .size_v = 1, .f = {1}};  // until the data is read
  fit.evaluations = c.evaluations.value_or(fit.evaluations);
  fit.between = c.between.value_or(fit.between);
  return options;
}

}  // namespace knotfit::tool
