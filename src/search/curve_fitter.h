// A curve of one size, or of given knots: placed, fitted, its parameters corrected, and held to its data where it swings.
#pragma once
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fit/curve_problem.h"
#include "knotfit/refine.h"
#include "knotfit/verify.h"
namespace knotfit {

struct FittedCurve {
  Index control_points = 0;                                ///< free ones
  double error = std::numeric_limits<double>::infinity();  ///< that counts, in the frame
  double rms = 0;                                          ///< in the frame
  std::vector<double> t, errors;                           ///< n, on the curve; |C(t_k) - P_k|
  Curve curve;                                             ///< clamped, over [0,1]
  SwingReport swings;
  double swing_before =
      0;  ///< of the least squares of its knots, where the data energy holds the curve; else 0
  bool empty() const { return t.empty(); }
};

class CurveFitter {
 public:
  /// \param points       in a frame; they and the others outlive the fitter
  /// \param options      the degree is degree_u
  /// \param corrections  rounds that move the parameters to feet
  /// \param measure      the tolerance in the frame, 0: none
  CurveFitter(const CurvePoints& points, const SearchOptions& options, int corrections,
              const Tolerance& measure, const Control& control)
      : points_(points), options_(options), corrections_(corrections), measure_(measure), control_(control) {}

  Index least() const { return options_.degree_u + 1; }
  long fits() const { return fits_; }
  const std::vector<std::string>& notes() const { return notes_; }

  /// Of a search: least squares alone; where they hold the tolerance and swing, again with the data energy.
  FittedCurve size(Index control_points);
  /// A size or knots of the user's: again with the data energy wherever the least squares swing.
  FittedCurve fixed_size(Index control_points);
  FittedCurve given(const std::vector<double>& knots);
  bool holds(const FittedCurve& fitted) const {
    return fitted.error <= measure_.value && !fitted.swings.swings;
  }

 private:
  using Energy = std::shared_ptr<const DataEnergy>;
  bool stopped() const { return control_.stop.stop_requested(); }
  /// A size or knots, fitted with this energy or none, corrected and judged.
  FittedCurve fit(Index control_points, const Energy& energy);
  FittedCurve fit(const std::vector<double>& knots, const Energy& energy);
  /// The plain curve or, where it swings, one of the same size or knots held to the data by an energy for errors of this scale,
  /// at least the tolerance's.
  template <class Size>
  FittedCurve held(FittedCurve plain, const Size& size, double scale);
  std::vector<double> place(CurveProblem& problem, Index control_points, const Energy& energy);
  FittedCurve take(CurveProblem& problem, const std::vector<double>& knots);
  /// Rounds of feet and fits at these knots. \return whether any parameter moved
  bool correct(CurveProblem& problem, const std::vector<double>& knots);
  void judge(FittedCurve& fitted) const;

  const CurvePoints& points_;
  const SearchOptions& options_;
  int corrections_;
  Tolerance measure_;
  const Control& control_;
  long fits_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace knotfit
