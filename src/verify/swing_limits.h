// How far a surface or a curve may leave its data between the points: one home for what the verdict allows.
#pragma once
#include "knotfit/index.h"
namespace knotfit::verify {

inline constexpr double kCountedSwing = 3;         ///< a swing above it counts
inline constexpr double kLargestSwing = 10;        ///< none may be above it
inline constexpr double kSwingShare = 1.0 / 2000;  ///< of the places may be above kCountedSwing
/// Beyond the box of all data: this share of its diagonal, or so many tolerances, whichever is more.
inline constexpr double kBoxShare = 0.02, kBoxTolerances = 2;
/// Beyond the outermost points a surface goes on as the data about does, by this share of the diagonal at most.
inline constexpr double kMostOnward = 0.1;
/// In gaps the data says less: this share of the range about, and more the farther in [METHOD 5.2]. What is allowed
/// there in all counts as a swing of kLargestSwing / kGapRatio.
inline constexpr double kGapRange = 0.2, kGapRatio = 2;
/// Places inside triangles that a search asks of every net that would become the best.
inline constexpr Index kSearchPlaces = 20000;

}  // namespace knotfit::verify
