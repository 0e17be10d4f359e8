// What a correction is made in: the mesh in its own frame, prepared once for any number of knots.
#pragma once
#include <vector>

#include "correct/correction_run.h"
#include "correct/holding_mesh.h"
#include "fit/frame.h"
#include "knotfit/correct.h"
namespace knotfit::correction {

class PreparedMesh {
 public:
  /// \param mesh  outlives this
  /// \throws InvalidInput  see correct_parameters(); knots are not looked at
  PreparedMesh(const Mesh& mesh, std::vector<double> uv, const CorrectionOptions& options);

  const Frame& frame() const { return frame_; }
  const CorrectionOptions& options() const { return options_; }  ///< the aspect is known
  const std::vector<double>& first() const { return first_; }

  /// \param uv       of the mesh's vertices, to begin with
  /// \param options  in the frame: start, keep_by
  CorrectionRun run(std::vector<double> uv, const KnotVector& knots_u, const KnotVector& knots_v,
                    const CorrectionOptions& options, const Stage& stage, bool keep_start = true) const;

  /// Of the distances in the knots of a surface in the frame. \return nothing where they cannot be solved for
  std::optional<KnotJacobian> knots(std::vector<double> uv, const Surface& surface) const;

  Index data() const { return data_; }  ///< vertices that are data
  /// The error that counts, over the diagonal.
  double error(const CorrectionResult& result, const Tolerance& tolerance) const;

  /// Out of the frame, parameters of the mesh's own triangles, distances and folds measured.
  CorrectionResult finish(CorrectionRun rounds, bool from_first_fit, const Control& control) const;

 private:
  const Mesh& mesh_;
  std::vector<double> first_;
  CorrectionOptions options_;
  Frame frame_;
  HoldingMesh holding_;
  Index data_;
  std::vector<Slide> sliding_;     ///< of foot points: the middles of holes have none and stay
  std::vector<Slide> untangling_;  ///< the middles of holes go with their triangles
};

}  // namespace knotfit::correction
