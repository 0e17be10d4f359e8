// Knots given, placed at a fixed size, or searched to a tolerance.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "knotfit/fit_surface.h"
namespace knotfit {

/// Works in the frame.
struct Chosen {
  InteriorKnots knots, metric;
  int degree_u = 3, degree_v = 3;
  Status status = Status::fixed_size;
  bool swings = false;  ///< the best surface found does
  double error = 0;     ///< the error that counts, where a search or a comparison of degrees measured it
  double criterion = 0;
  std::vector<SizeTried> tried;
  long fits = 0;
  std::string method;
  std::optional<Surface> surface;  ///< where the control points are not the least squares' of the knots
  Index fill_points = 0;
  Index sample = 0;
  std::vector<std::string> notes;
};

/// The energy that holds a surface to its data between the points, and the places where that is measured. Made once a call.
struct Keeping {
  std::shared_ptr<const DataEnergy> energy;  ///< none: the smoothing floor alone
  std::shared_ptr<const verify::SwingSites> sites;
};

/// \param inside     points in the frame
/// \param tolerance  in the frame; value 0: none
/// \param noise      standard deviation found in the data, in the frame
Chosen choose_knots(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
                    double noise, const Keeping& keeping, const Control& control);

}  // namespace knotfit
