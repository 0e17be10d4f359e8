#include "pipeline/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "pipeline/message.h"
#include "verify/swing_limits.h"
namespace knotfit {
namespace {

std::string what_helps() {
  return fmt::format(
      "parameters that fit the points better ({}), more data there, a smoother surface ({}) or a larger "
      "tolerance help",
      remedy_text(Remedy::correct), remedy_text(Remedy::smoothing));
}

std::string place_text(const ParameterMap& map, double u, double v) {
  const auto [a, b] = map.from_uv(u, v);
  return fmt::format("{} = {:.9g}, {} = {:.9g}", map.name_u, a, map.name_v, b);
}

}  // namespace

Status status_of(const Findings& f) {
  const bool cut = f.searched == Status::stopped || f.searched == Status::time_limit;
  if (!f.with_tolerance || cut) return f.searched;
  if (f.holds) return f.swings ? Status::swings : f.folded ? Status::folded : Status::reached;
  return f.search && f.searched != Status::reached ? f.searched : Status::not_reached;
}

void judge(FitResult& result, const ParameterizedPoints& points, Status searched, bool with_tolerance,
           bool search) {
  result.error = summarize_errors(result.errors, points);
  result.measured = with_tolerance ? measured_error(result.errors, result.asked) : result.error.max;
  const bool holds = with_tolerance && result.measured <= result.tolerance;
  result.reached = holds && !result.swings.swings;
  result.status = status_of({searched, search, with_tolerance, holds, result.swings.swings, false});
}

void judge_all_points(FitResult& result, const std::vector<double>& errors) {
  if (result.surface.empty() || result.status == Status::failed) return;
  if (errors.size() < result.errors.size())
    throw InvalidInput(
        fmt::format("{} errors of all points, though {} were fitted", errors.size(), result.errors.size()));
  for (const double e : errors)
    if (!(e >= 0) || !std::isfinite(e))
      throw InvalidInput(fmt::format("an error of {}: it must be finite and not negative", e));
  result.left_out = static_cast<Index>(errors.size() - result.errors.size());
  if (result.left_out == 0) return;
  result.all_max = *std::max_element(errors.begin(), errors.end());
  if (result.tolerance > 0) {
    result.measured = measured_error(errors, result.asked);
    result.reached = result.reached && result.measured <= result.tolerance;
    if (result.status == Status::reached && !result.reached) result.status = Status::not_reached;
  }
  result.message = message_of(result, static_cast<Index>(result.errors.size()));
}

std::string held_note(double before, double left, std::string_view what) {
  return fmt::format(
      "the least squares of these knots swing between the points (by {:.3g} times the errors there): an "
      "energy that follows the data's own spacing {} the {}",
      before, left <= verify::kLargestSwing ? "holds" : "lessens the swings of", what);
}

std::string swing_text(const SwingReport& s, double diagonal, std::string_view what,
                       const std::function<std::string(double, double)>& place) {
  std::string text = fmt::format("the {} swings between the points", what);
  const bool counted = s.largest > verify::kCountedSwing;
  if (counted)
    text += fmt::format(": at {} it leaves the range of the points about by {:.3g}, {:.3g} times {}",
                        place(s.worst_u, s.worst_v), s.distance, s.largest,
                        s.in_gap ? "what such a gap allows" : "the larger of the tolerance and their errors");
  if (s.beyond_box > verify::kBoxShare * diagonal)
    text += fmt::format("{} at {} it leaves the box of all data by {:.3g}", counted ? ", and" : ":",
                        place(s.box_u, s.box_v), s.beyond_box);
  return text;
}

void note_swings(FitResult& result) {
  if (!result.swings.swings) return;
  const std::string text = swing_text(result.swings, result.diagonal, "surface",
                                      [&](double u, double v) { return place_text(result.map, u, v); });
  result.notes.insert(result.notes.begin(), text + "; " + what_helps());
}

}  // namespace knotfit
