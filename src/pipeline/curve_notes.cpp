#include "pipeline/curve_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "knotfit/remedy.h"
#include "pipeline/verdict.h"

namespace knotfit {
namespace {

constexpr double kLongGap = 0.1;  // of the curve's length
constexpr double kManySteps = 8;  // between neighbouring points, in the median
constexpr Index kPlaces = 4000;   // the curve's length is that of a polygon through so many

/// Length of the curve from 0 to k / kPlaces.
std::vector<double> lengths_along(const Curve& curve) {
  std::vector<double> t(kPlaces + 1);
  for (Index k = 0; k <= kPlaces; ++k) t[k] = static_cast<double>(k) / kPlaces;
  const std::vector<double> at = evaluate(curve, t);
  const int d = curve.dimension();
  std::vector<double> length{0};
  for (Index k = 1; k <= kPlaces; ++k) {
    double square = 0;
    for (int c = 0; c < d; ++c) square += std::pow(at[k * d + c] - at[(k - 1) * d + c], 2);
    length.push_back(length.back() + std::sqrt(square));
  }
  return length;
}

std::string gap_note(const CurveFitResult& fit) {
  const std::vector<double> length = lengths_along(fit.curve);
  const auto upto = [&](double t) {
    const double at = std::clamp(t, 0.0, 1.0) * kPlaces;
    const Index k = std::min<Index>(static_cast<Index>(at), kPlaces - 1);
    return length[k] + (at - static_cast<double>(k)) * (length[k + 1] - length[k]);
  };
  std::vector<double> t = fit.t, step;
  std::sort(t.begin(), t.end());
  if (t.size() < 4 || !(length.back() > 0)) return "";
  if (fit.closed) t.push_back(1 + t.front());
  Index widest = -1;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    step.push_back(t[k + 1] > 1 ? length.back() - upto(t[k]) + upto(t[k + 1] - 1)
                                : upto(t[k + 1]) - upto(t[k]));
    if (widest < 0 || step.back() > step[widest]) widest = static_cast<Index>(k);
  }
  const double gap = step[widest];
  const auto middle = step.begin() + static_cast<std::ptrdiff_t>(step.size() / 2);
  std::nth_element(step.begin(), middle, step.end());
  if (!(gap > kLongGap * length.back()) || !(gap > kManySteps * *middle)) return "";
  std::string note = fmt::format(
      "{:.2g} % of the curve's length, from t = {:.4g} to t = {:.4g}, hold no data: the "
      "curve is free there",
      100 * gap / length.back(), t[widest], std::fmod(t[widest + 1], 1.0));
  if (fit.closed && gap > 0.25 * length.back())
    note += "; without " + remedy_text(Remedy::closed) + " it ends at the data";
  return note;
}

/// The note that leads where a curve swings.
std::string swing_note(const CurveFitResult& fit, const CurvePoints& points) {
  const std::string note = swing_text(fit.swings, fit.diagonal, "curve", [&](double t, double) {
    return points.function ? fmt::format("x = {:.9g}", points.x0 + t * (points.x1 - points.x0))
                           : fmt::format("t = {:.4g}", t);
  });
  const std::string parameters = points.function ? ""
                                                 : fmt::format("parameters that fit the points better ({}), ",
                                                               remedy_text(Remedy::corrections));
  return note + fmt::format("; {}more data there, a smoother curve ({}) or a larger tolerance help",
                            parameters, remedy_text(Remedy::smoothing));
}

}  // namespace

std::vector<std::string> curve_notes(const CurveFitResult& fit, const CurvePoints& points) {
  std::vector<std::string> notes;
  if (fit.swings.swings) notes.push_back(swing_note(fit, points));
  if (points.function || fit.curve.dimension() < 2) return notes;
  if (std::string gap = gap_note(fit); !gap.empty()) notes.push_back(std::move(gap));
  const auto d = static_cast<std::size_t>(points.dimension);
  const std::vector<double>& v = points.values;
  if (!points.closed && v.size() >= 4 * d &&
      std::equal(v.begin(), v.begin() + points.dimension, v.end() - points.dimension))
    notes.push_back("the first and the last point are equal: " + remedy_text(Remedy::closed) +
                    " fits a curve that runs on smoothly there");
  return notes;
}

}  // namespace knotfit
