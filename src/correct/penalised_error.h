// The error that surfaces of a correction are compared by [METHOD 8.1].
#pragma once
namespace knotfit::correction {

/// \param folded  share of the square where the surface is folded
inline double penalised_error(double error, double folded) {
  constexpr double kFoldPenalty = 20;  // set
  return error * (1 + kFoldPenalty * folded);
}

}  // namespace knotfit::correction
