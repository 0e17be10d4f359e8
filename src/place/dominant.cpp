#include <algorithm>
#include <cmath>
#include <numeric>

#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// The lines of one direction that were picked, and how the rows bend between them.
class Dominant {
 public:
  Dominant(const RowGrid& grid, bool along_v, int degree, int wanted)
      : lines_(grid.lines(along_v)),
        degree_(degree),
        wanted_(static_cast<std::size_t>(wanted) + degree + 1),
        shape_(row_shape(grid, along_v)) {
    start();
  }
  bool complete() const { return picked_.size() >= wanted_; }
  std::size_t segments() const { return picked_.size() - 1; }
  bool can_split(std::size_t s) const { return picked_[s + 1] - picked_[s] > 1; }
  std::vector<double> knots() const {
    std::vector<double> t;
    for (Index i : picked_) t.push_back(lines_[i]);
    return averaged_knots(t, degree_);
  }
  std::size_t segment(double t) const {
    std::size_t s = 0;
    while (s + 2 < picked_.size() && t >= lines_[picked_[s + 1]]) ++s;
    return s;
  }
  /// Step 4.
  void split(std::size_t s) {
    const Index low = picked_[s], high = picked_[s + 1];
    const double bends = std::max(sum(shape_.bend), 1e-300), lengths = std::max(sum(shape_.length), 1e-300);
    std::vector<double> index(high - low + 1, 0.0);  // from `low` to each line, its own bend left out
    for (Index i = low + 1; i <= high; ++i)
      index[i - low] = index[i - low - 1] + 0.8 * (i - 1 > low ? shape_.bend[i - 1] : 0.0) / bends +
                       0.2 * shape_.length[i] / lengths;
    Index best = low + 1;
    double least = INFINITY;
    for (Index w = low + 1; w < high; ++w) {
      // The bend at w is in neither half.
      const double after = index[high - low] - index[w - low] - 0.8 * shape_.bend[w] / bends;
      if (const double off = std::abs(index[w - low] - after); off < least) {
        least = off;
        best = w;
      }
    }
    picked_.insert(picked_.begin() + static_cast<Index>(s) + 1, best);
  }

 private:
  static double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

  /// Step 1.
  void start() {
    const Index count = static_cast<Index>(lines_.size());
    picked_ = {0, count - 1};
    const double mean = sum(shape_.bend) / static_cast<double>(count);
    std::vector<Index> peaks;
    for (Index i = 1; i + 1 < count; ++i)
      if (shape_.bend[i] > mean && shape_.bend[i] >= shape_.bend[i - 1] &&
          shape_.bend[i] > shape_.bend[i + 1])
        peaks.push_back(i);
    std::stable_sort(peaks.begin(), peaks.end(),
                     [&](Index a, Index b) { return shape_.bend[a] > shape_.bend[b]; });
    for (Index i : peaks)
      if (picked_.size() < std::min<std::size_t>(wanted_, degree_ + 4)) picked_.push_back(i);
    std::sort(picked_.begin(), picked_.end());
    while (picked_.size() < static_cast<std::size_t>(degree_) + 1) {
      std::size_t longest = 0;
      for (std::size_t s = 0; s < segments(); ++s)
        if (picked_[s + 1] - picked_[s] > picked_[longest + 1] - picked_[longest]) longest = s;
      if (!can_split(longest)) break;  // fewer lines than control points
      picked_.insert(picked_.begin() + static_cast<Index>(longest) + 1,
                     (picked_[longest] + picked_[longest + 1]) / 2);
    }
  }

  const std::vector<double>& lines_;
  int degree_;
  std::size_t wanted_;
  RowShape shape_;
  std::vector<Index> picked_;
};

}  // namespace

/// Dominant columns and rows [Park11; in one direction the dominant points of Park07]. The papers were not at hand;
/// these are the steps as later literature gives them [METHOD 2.3]; the weights 0.8 and 0.2, and the error that
/// chooses the direction, are ours. With b_i the turning angles and l_i the lengths at line i, added over the rows:
///  1. the two ends, then the highest local maxima of b above its mean, to at most m + 4 lines; to m + 1 by
///     halving the longest gap;
///  2. knots of the lines d_0 < ... < d_{D-1}: u_j = (t_{d_j} + ... + t_{d_{j+m-1}})/m, j = 1..D-m-1;
///  3. fit with the knots of both directions; e_s = sum of |r|^2 of the points between two neighbours; the largest
///     e over the directions still short of knots is split
///  4. at the line w where the shape index is halved: least |L(lo,w) - L(w,hi)|,
///     L(x,y) = sum_{x<i<=y} 0.8 b_i [i<y]/sum b + 0.2 l_i/sum l;
///  5. 3 and 4 to the counts wanted, one fit a line.
Placement place_dominant(PlacementContext& context, int interior_u, int interior_v) {
  FitProblem& problem = context.problem();
  const RowGrid& grid = context.row_grid();
  Dominant directions[2] = {{grid, false, problem.degree_u(), interior_u},
                            {grid, true, problem.degree_v(), interior_v}};
  const ParameterizedPoints& points = problem.points();
  while (!context.stop_requested() && !(directions[0].complete() && directions[1].complete())) {
    if (!problem.solve({directions[0].knots(), directions[1].knots()})) break;
    const std::vector<double> errors = problem.errors();
    double largest = -1;
    int axis = 0;
    std::size_t segment = 0;
    for (int a : {0, 1}) {
      const Dominant& d = directions[a];
      if (d.complete()) continue;
      std::vector<double> squares(d.segments(), 0.0);
      for (Index k = 0; k < points.size(); ++k)
        squares[d.segment(points.uv[2 * k + a])] += errors[k] * errors[k];
      for (std::size_t s = 0; s < squares.size(); ++s)
        if (d.can_split(s) && squares[s] > largest) {
          largest = squares[s];
          axis = a;
          segment = s;
        }
    }
    if (largest < 0) break;  // every line is picked
    directions[axis].split(segment);
  }
  Placement placement;
  placement.knots = {directions[0].knots(), directions[1].knots()};
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
