// Maps in several metrics and with corners by several rules, and the one that a fit likes best.
#pragma once
#include <optional>
#include <vector>

#include "base/stage.h"
#include "knotfit/parameterize_mesh.h"
#include "parameterize/mesh_border.h"
#include "parameterize/mesh_elimination.h"
#include "parameterize/mesh_trial_fit.h"
namespace knotfit::mesh_map {

struct Choices {
  std::vector<double> omegas;
  CornerRule rule = CornerRule::automatic;
  std::optional<Corners> corners;  ///< given: then the rule is only a name
  bool newton = true;
  int newton_rounds = 30;
};

struct ChosenMap {
  std::vector<double> uv;  ///< halving vertices too
  Corners corners{};
  double omega = 0;
  CornerRule rule = CornerRule::sharpest;
  TrialFit fit;
};

/// Every choice for a few rounds of Newton, the better ones for more, the best two to the end; the
/// least error of a trial fit wins. Independent of the number of threads.
ChosenMap best_map(const DiskMesh& disk, const Choices& choices, const Stage& stage);

}  // namespace knotfit::mesh_map
