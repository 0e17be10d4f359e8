// Sizes for a mesh whose parameters move: each begins with the surface and the parameters of a smaller one
// [METHOD 8.12].
#pragma once
#include <optional>

#include "search/mesh_rounds.h"
#include "search/search_run.h"
#include "search/size_solver.h"
namespace knotfit {

class MeshSizes final : public SizeSolver {
 public:
  /// \param run  its tolerance is in the frame of the mesh
  MeshSizes(const correction::PreparedMesh& prepared, const SearchOptions& options, SearchRun& run,
            const Control& control);

  /// \param from  the size that failed last, whose surface and parameters this one begins with; null: from the map
  const SizeOutcome& solve(const Spans& spans, const Spans* from) override;

  /// The smallest that holds once more with the fairness charged, taken where it still holds and its normals are nearer
  /// the mesh's. The search is blind to it: on nets that are too coarse for the mesh it would only lead astray.
  void make_fair();

  bool interrupted() const { return run_.interrupted(mesh_rounds_.fits()); }
  long fits() const { return mesh_rounds_.fits(); }
  Index size(const Spans& s) const {
    return (s.first + Index{options_.degree_u}) * (s.second + Index{options_.degree_v});
  }
  Index folded() const { return folded_; }  ///< the first size that holds the tolerance and folds; 0: none
  /// The one that holds, else the one of least error.
  CorrectionResult result();

 private:
  struct State {
    Spans spans{};
    correction::CorrectionRun rounds;
  };
  enum class Verdict { misses, folds, holds };

  static InteriorKnots uniform(const Spans& s);
  bool near(const correction::CorrectionRun& r) const;
  correction::CorrectionRun polished(correction::CorrectionRun base) const;
  /// Measured on the whole surface. One that only folds is kept until a larger one does not.
  Verdict verify(State& state);
  /// What a size may still gain, where the tolerance is near: first on its knots, then on others as far as the method moves
  /// them. \return true where it holds, verified
  bool settle(const State& state);

  const correction::PreparedMesh& prepared_;
  const SearchOptions& options_;
  const Control& control_;
  SearchRun& run_;
  MeshKnots knots_;
  MeshRounds mesh_rounds_;
  int rounds_;
  State best_;
  std::optional<State> failed_;     ///< the last that failed: the next size begins with it
  correction::CorrectionRun held_;  ///< of the size that holds
  std::optional<CorrectionResult> verified_;
  Index folded_ = 0;
};

}  // namespace knotfit
