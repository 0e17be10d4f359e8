// What surfaces of a correction are compared by: the penalised error [METHOD 8.1].
#pragma once
namespace knotfit::correction {

/// \param error   that counts   \param folded  share of the square
inline double merit_of(double error, double folded) {
  constexpr double kFoldPenalty = 20;
  return error * (1 + kFoldPenalty * folded);
}

}  // namespace knotfit::correction
