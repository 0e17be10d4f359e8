// The table of methods: a new one is its own file, its declaration in context.h, and a line here.
#include <fmt/format.h>

#include <array>

#include "knotfit/errors.h"
#include "place/context.h"
namespace knotfit {
namespace {

struct Entry {
  PlacementMethod method;
  PlaceFunction place;
};

constexpr std::array entries{
    Entry{{"optimal", "knots that minimise the fitting error itself, by variable projection",
           "Golub & Pereyra 1973; Kaufman 1975; Jupp 1978"},
          place_optimal},
    Entry{{"error-model", "equal shares of the error that the present fit's derivatives predict, iterated",
           "de Boor, A Practical Guide to Splines (NEWNOT), carried to surfaces"},
          place_error_model},
    Entry{{"criterion", "cells of equal feature content: sum of squared cell features by coordinate descent",
           "Zhang, Cao, Chen, Li, Zeng, Computers & Graphics 2016"},
          place_criterion},
    Entry{{"uniform", "equally spaced knots", "the baseline"}, place_uniform},
    Entry{{"quantile", "the same number of points in every strip", "quantiles of the sorted parameters"},
          place_quantile},
};

constexpr auto table = [] {
  std::array<PlacementMethod, entries.size()> methods{};
  for (std::size_t i = 0; i < entries.size(); ++i) methods[i] = entries[i].method;
  return methods;
}();

}  // namespace

std::span<const PlacementMethod> placement_methods() {
  return table;
}

PlaceFunction find_method(std::string_view name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.method.name == name) return entry.place;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.method.name);
  }
  throw InvalidInput(fmt::format("there is no placement method '{}'; there are {}", name, known));
}

Placement place_knots(std::string_view method, const ParameterizedPoints& points,
                      const PlacementOptions& options, const Control& control) {
  const PlaceFunction place = find_method(method);
  if (options.interior_u < 0 || options.interior_v < 0)
    throw InvalidInput(fmt::format("{} x {} interior knots: neither may be negative", options.interior_u,
                                   options.interior_v));
  if (options.rounds < 0 || options.sweeps < 0)
    throw InvalidInput(
        fmt::format("{} rounds and {} sweeps: neither may be negative", options.rounds, options.sweeps));
  LeastSquaresOptions fit;
  fit.smoothing = options.smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.use_grid = method != "optimal";
  FitProblem problem(points, options.degree_u, options.degree_v, fit);
  PlacementContext context(problem, options, control);
  Placement placement = place(context, options.interior_u, options.interior_v);
  placement.fits = problem.fits();
  return placement;
}

}  // namespace knotfit
