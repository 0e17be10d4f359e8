// The last rounds of a correction to a maximum or a percentile: L_P with growing P [METHOD 8.10].
#pragma once
#include <functional>

#include "base/stage.h"
#include "correct/batch.h"
namespace knotfit::correction {

/// Reweighted tangent steps on Phi = sum q^P / P + eps q^2 / 2, q the distance over the error that counts (with a
/// percentile: at most 1), shortened until Phi falls.
/// \param visit  each round's record, verdict and surface; the rounds end where it returns false
/// \return false where the stage ended them
bool minimax_rounds(Batch& batch, Surface surface, const CorrectionOptions& options,
                    std::vector<double>& hinge_weights, const Stage& stage,
                    const std::function<bool(const CorrectionRound&, const Verdict&, const Surface&)>& visit);

}  // namespace knotfit::correction
