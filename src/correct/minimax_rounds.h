// The last rounds of a correction to a maximum or a percentile: L_P with growing P [METHOD 8.10].
#pragma once
#include <functional>

#include "base/stage.h"
#include "correct/mesh_at_parameters.h"
namespace knotfit::correction {

/// Lowers Phi = sum q^P / P + eps q^2 / 2 by tangent steps with weights; q is the distance over the error that counts (with a
/// percentile at most 1). A step is halved until Phi falls.
/// \param visit  each round's record, judgement and surface; the rounds end where it returns false
/// \return false where the stage ended them
bool minimax_rounds(
    MeshAtParameters& mesh, Surface surface, const CorrectionOptions& options,
    std::vector<double>& hinge_weights, const Stage& stage,
    const std::function<bool(const CorrectionRound&, const Judgement&, const Surface&)>& visit);

}  // namespace knotfit::correction
