// The table of methods: a new one is its own file, its declaration in context.h, and a line here.
#include <fmt/format.h>

#include <array>

#include "data/sample.h"
#include "knotfit/exceptions.h"
#include "place/context.h"
#include "place/sample_size.h"
#ifdef KNOTFIT_WITH_NLOPT
#include "place/evolutionary.h"
#endif
namespace knotfit {
namespace {

struct Entry {
  PlacementMethod method;
  PlaceFunction place;
};

constexpr std::array entries{
    Entry{{"optimal",
           "knots that minimise the fitting error itself, by variable projection",
           "Golub & Pereyra 1973; Kaufman 1975; Jupp 1978",
           {.moves_knots = true, .on_mesh = MeshKnots::moved}},
          place_optimal},
    Entry{{"error-model",
           "equal shares of the error that the present fit's derivatives predict, iterated",
           "de Boor, A Practical Guide to Splines (NEWNOT), carried to surfaces",
           {.refits = true, .on_mesh = MeshKnots::anew}},
          place_error_model},
    Entry{{"criterion", "cells of equal feature content: sum of squared cell features by coordinate descent",
           "Zhang, Cao, Chen, Li, Zeng, Computers & Graphics 2016"},
          place_criterion},
    Entry{{"uniform", "equally spaced knots", "the baseline", {.on_mesh = MeshKnots::uniform}},
          place_uniform},
    Entry{{"quantile", "the same number of points in every strip", "quantiles of the sorted parameters"},
          place_quantile},
    Entry{{"averaging", "means of neighbouring parameters, one in every span",
           "Piegl & Tiller, The NURBS Book, (9.68), (9.69)"},
          place_averaging},
    Entry{{"equal-share", "equal shares of the marginals of the feature measure",
           "de Boor, A Practical Guide to Splines, XII"},
          place_equal_share},
    Entry{{"centroid", "centroids of regions of equal accumulated feature",
           "the literature on feature-based knots"},
          place_centroid},
    Entry{{"derivative-share",
           "equal shares of the root of the data's own derivative of that order",
           "Yeh, Nashed, Peterka, Tricoche, Computer-Aided Design 2020",
           {.needs_rows = true}},
          place_derivative_share},
    Entry{{"nktp",
           "means of groups of parameters, averaged over the degree",
           "Piegl & Tiller, The Visual Computer 2000",
           {.needs_rows = true}},
          place_nktp},
    Entry{{"dominant",
           "columns and rows where the data bends, split where errors are large",
           "Park, Computer-Aided Design 2011; curves: Park & Lee 2007",
           {.needs_rows = true}},
          place_dominant},
    Entry{{"fitpack", "a knot at a time where residuals are large: the greedy rule of surfit",
           "Dierckx, Curve and Surface Fitting with Splines, 1993, 5.4"},
          place_fitpack},
    Entry{{"sparse",
           "knots where a fit with few jumps of its derivative keeps them",
           "Kang, Chen, Li, Deng, Yang, Computer-Aided Design 2015",
           {.needs_rows = true}},
          place_sparse},
    Entry{{"full-lspia",
           "control points by progressive iteration, knots by their gradient, in turn; then knots removed",
           "Lan, Ji, Wang, Zhu, Computer-Aided Design 2024"},
          place_full_lspia},
    Entry{{"conjugate-gradient", "knots and control points together by conjugate gradients",
           "after Xie & Qin, Shape Modeling International 2001"},
          place_conjugate_gradient},
#ifdef KNOTFIT_WITH_NLOPT
    Entry{{"evolutionary", "global search over the knots: ESCH",
           "NLopt; Silva Santos, Goncalves, Hernandez-Figueroa 2010"},
          place_evolutionary},
    Entry{{"evolutionary-crs", "global search over the knots: controlled random search",
           "NLopt; Price 1983; Kaelo & Ali 2006"},
          place_evolutionary_crs},
    Entry{{"evolutionary-isres", "global search over the knots: evolution strategy with stochastic ranking",
           "NLopt; Runarsson & Yao 2005"},
          place_evolutionary_isres},
#endif
};

constexpr auto table = [] {
  std::array<PlacementMethod, entries.size()> methods{};
  for (std::size_t i = 0; i < entries.size(); ++i) methods[i] = entries[i].method;
  return methods;
}();

const Entry& entry_of(std::string_view name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.method.name == name) return entry;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.method.name);
  }
#ifndef KNOTFIT_WITH_NLOPT
  if (name.starts_with("evolutionary"))
    throw InvalidInput(
        fmt::format("this knotfit was built without NLopt, which the method '{}' needs", name));
#endif
  throw InvalidInput(fmt::format("there is no placement method '{}'; there are {}", name, known));
}

}  // namespace

std::span<const PlacementMethod> placement_methods() {
  return table;
}

const PlacementMethod& placement_method(std::string_view name) {
  return entry_of(name).method;
}

PlaceFunction find_method(std::string_view name) {
  return entry_of(name).place;
}

Placement place_knots(std::string_view method, const ParameterizedPoints& points,
                      const PlacementOptions& options, const Control& control) {
  const Entry& entry = entry_of(method);
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
  fit.energy = options.energy;
  const auto place_in = [&](auto&& problem) {
    PlacementContext context(problem, options, control);
    Placement placement = entry.place(context, options.interior_u, options.interior_v);
    placement.fits = problem.fits() + context.other_fits();
    placement.notes.insert(placement.notes.end(), context.notes().begin(), context.notes().end());
    return placement;
  };
  const MethodTraits& traits = entry.method.traits;
  const auto place_on = [&](const ParameterizedPoints& p) {
    return traits.moves_knots ? place_in(MovingFit(p, options.degree_u, options.degree_v, fit))
                              : place_in(FitProblem(p, options.degree_u, options.degree_v, fit));
  };
  const double control_points = static_cast<double>(options.interior_u + options.degree_u + 1) *
                                static_cast<double>(options.interior_v + options.degree_v + 1);
  const Index size =
      traits.moves_knots || traits.refits ? sample_size(points.size(), control_points, options.engine) : 0;
  // Fits of a grid are quick, whatever its number of points; knots that move are fitted to scattered points anyway.
  const bool quick = size > 0 && !traits.moves_knots && !fitted_grid(points).empty();
  if (size == 0 || quick) return place_on(points);
  const ParameterizedPoints sample = stratified_sample(points, size);
  Placement placement = place_on(sample);
  placement.sample = sample.size();
  return placement;
}

}  // namespace knotfit
