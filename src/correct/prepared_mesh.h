// A mesh in its own frame, prepared once for corrections over any knots.
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
  /// \throws InvalidInput  see correct_parameters(); knots are not checked
  PreparedMesh(const Mesh& mesh, std::vector<double> uv, const CorrectionOptions& options);

  const Frame& frame() const { return frame_; }
  const CorrectionOptions& options() const { return options_; }  ///< the aspect is known
  const std::vector<double>& first() const { return first_; }

  /// \param uv       of the mesh's vertices at the start
  /// \param options  in the frame: start, keep_by
  CorrectionRun run(std::vector<double> uv, const KnotVector& knots_u, const KnotVector& knots_v,
                    const CorrectionOptions& options, const Stage& stage, bool keep_start = true) const;

  /// How the distances change with the knots of a surface in the frame. \return nothing where the control points cannot be
  /// solved for
  std::optional<KnotJacobian> knots(std::vector<double> uv, const Surface& surface) const;

  Index data() const { return data_; }  ///< vertices that are data
  /// The error that counts, in the frame.
  double error(const CorrectionResult& result, const Tolerance& tolerance) const;

  /// Takes the surface out of the frame, finds parameters that suit the mesh's own triangles, and measures distances and folds.
  CorrectionResult finish(CorrectionRun rounds, bool from_first_fit, const Control& control) const;

 private:
  const Mesh& mesh_;
  std::vector<double> first_;
  CorrectionOptions options_;
  Frame frame_;
  HoldingMesh holding_;
  Index data_;
  std::vector<Slide> sliding_;     ///< to foot points: vertices that are no data have none and stay
  std::vector<Slide> untangling_;  ///< to untangle: vertices that are no data move too
};

/// Keeps of what a result has by vertex the first ones: without the middles of a map's halved edges.
void keep_first(Index vertices, CorrectionResult& result);

}  // namespace knotfit::correction
