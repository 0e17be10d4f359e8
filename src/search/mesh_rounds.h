// Rounds of correction at one size, with knots that may move between them [METHOD 8.11].
#pragma once
#include <vector>

#include "correct/prepared_mesh.h"
#include "knotfit/interior_knots.h"
namespace knotfit {

class MeshRounds {
 public:
  /// \param tolerance  what counts as the error, in the frame of the mesh
  /// \param of_search  fairness is left to faired(), progress to the caller
  MeshRounds(const correction::PreparedMesh& prepared, int degree_u, int degree_v, const Tolerance& tolerance,
             const Control& control, bool of_search);

  /// \param start   carried over to the knots; null: the plain fit
  /// \param enough  the error that ends the rounds; 0: none
  correction::CorrectionRun correct(const std::vector<double>& uv, const InteriorKnots& knots,
                                    const Surface* start, int rounds, double enough = 0,
                                    int minimax = 0) const;

  bool meets(const correction::CorrectionRun& r) const { return r.surface && r.error <= tolerance_.value; }
  /// With last rounds for the tolerance itself where it is not met; the better of both.
  correction::CorrectionRun polished(correction::CorrectionRun base) const;

  /// Rounds that charge the fairness, those for the tolerance after them, whatever that does to the error.
  correction::CorrectionRun faired(const correction::CorrectionRun& base) const;

  /// Knots by the error model on the corrected surface, at its size, with rounds after them; the better of both.
  correction::CorrectionRun with_knots_anew(correction::CorrectionRun base, int rounds) const;
  /// Levenberg-Marquardt steps of the knots on the distances, each with rounds of its own; the RMS falls.
  correction::CorrectionRun with_knots_moved(correction::CorrectionRun base, int steps) const;

  /// The later one, its rounds counted after the earlier one's.
  static correction::CorrectionRun after(correction::CorrectionRun earlier, correction::CorrectionRun later);
  long fits() const { return fits_; }

 private:
  CorrectionOptions options(int rounds, const Tolerance& keep_by) const;
  correction::CorrectionRun run(const std::vector<double>& uv, const InteriorKnots& knots,
                                const Surface* start, CorrectionOptions options,
                                bool keep_start = true) const;

  const correction::PreparedMesh& prepared_;
  int degree_u_, degree_v_;
  Tolerance tolerance_;
  Control control_;
  double fairness_;
  Stage stage_;
  mutable long fits_ = 0;
};

}  // namespace knotfit
