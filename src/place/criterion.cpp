// The cell criterion E(U,V) = sum_ij F_ij^2 and its descent [Zhang16; METHOD 2.2].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "place/context.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// Cumulative table of f: entry (i, j) the share of f in [0, i/size_u] x [0, j/size_v].
class Shares {
 public:
  explicit Shares(const FeatureMap& map, bool transpose)
      : rows_(transpose ? map.size_v : map.size_u),
        columns_(transpose ? map.size_u : map.size_v),
        table_((rows_ + 1) * (columns_ + 1), 0.0) {
    for (Index i = 0; i < rows_; ++i)
      for (Index j = 0; j < columns_; ++j)
        at(i + 1, j + 1) = (transpose ? map.f[j * map.size_v + i] : map.f[i * map.size_v + j]) +
                           at(i, j + 1) + at(i + 1, j) - at(i, j);
    const double total = at(rows_, columns_);
    for (double& x : table_) x = total > 0 ? x / total : 0;
  }
  Index rows() const { return rows_; }

  /// Column j: the mass to the left of each row line within strip j of the other direction's knots,
  /// (rows + 1) x (others.size() + 1), row-major.
  std::vector<double> strips(const std::vector<double>& others) const {
    const std::size_t count = others.size() + 1;
    std::vector<double> result((rows_ + 1) * count);
    for (Index i = 0; i <= rows_; ++i) {
      double before = 0;
      for (std::size_t j = 0; j < count; ++j) {
        const double here = across(i, j < others.size() ? others[j] : 1.0);
        result[i * count + j] = here - before;
        before = here;
      }
    }
    return result;
  }

 private:
  double& at(Index i, Index j) { return table_[i * (columns_ + 1) + j]; }
  double across(Index i, double y) const {
    const double t = y * static_cast<double>(columns_);
    const Index j = std::min(static_cast<Index>(t), columns_ - 1);
    const double* row = table_.data() + i * (columns_ + 1);
    return row[j] + (t - static_cast<double>(j)) * (row[j + 1] - row[j]);
  }
  Index rows_, columns_;
  std::vector<double> table_;
};

/// The strips' cumulative masses at x: linear between grid lines.
class Strips {
 public:
  Strips(const Shares& shares, const std::vector<double>& others)
      : rows_(shares.rows()), count_(others.size() + 1), mass_(shares.strips(others)) {}
  std::size_t count() const { return count_; }
  Index rows() const { return rows_; }
  const double* row(Index i) const { return mass_.data() + i * count_; }
  void at(double x, std::vector<double>& out) const {
    const double t = std::clamp(x, 0.0, 1.0) * static_cast<double>(rows_);
    const Index i = std::min(static_cast<Index>(t), rows_ - 1);
    const double f = t - static_cast<double>(i);
    out.resize(count_);
    for (std::size_t j = 0; j < count_; ++j) out[j] = row(i)[j] + f * (row(i + 1)[j] - row(i)[j]);
  }
  /// sum_j (D_j(x) - low_j)^2 + (high_j - D_j(x))^2
  double objective(double x, const std::vector<double>& low, const std::vector<double>& high,
                   std::vector<double>& work) const {
    at(x, work);
    double sum = 0;
    for (std::size_t j = 0; j < count_; ++j)
      sum += (work[j] - low[j]) * (work[j] - low[j]) + (high[j] - work[j]) * (high[j] - work[j]);
    return sum;
  }

 private:
  Index rows_;
  std::size_t count_;
  std::vector<double> mass_;
};

double energy(const Strips& strips, const std::vector<double>& knots) {
  std::vector<double> before(strips.count(), 0.0), here;
  double sum = 0;
  for (std::size_t i = 0; i <= knots.size(); ++i) {
    strips.at(i < knots.size() ? knots[i] : 1.0, here);
    for (std::size_t j = 0; j < strips.count(); ++j) sum += (here[j] - before[j]) * (here[j] - before[j]);
    before = here;
  }
  return sum;
}

/// Moves every knot in turn to the exact minimum between its neighbours. Between two grid lines the
/// objective is a quadratic in x: its least over all of them, and over their ends, is the least.
/// \return the largest move made
double sweep(const Strips& strips, std::vector<double>& knots) {
  double largest = 0;
  std::vector<double> low, high, work, left, right;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double a = i > 0 ? knots[i - 1] : 0, b = i + 1 < knots.size() ? knots[i + 1] : 1;
    // Strictly inside: a knot must not run into its neighbour.
    const double margin = 1e-6 * (b - a), from = a + margin, to = b - margin;
    strips.at(a, low);
    strips.at(b, high);
    const double present = strips.objective(knots[i], low, high, work);
    double best = present, best_x = knots[i];
    auto consider = [&](double x) {
      const double value = strips.objective(x, low, high, work);
      if (value < best) {
        best = value;
        best_x = x;
      }
    };
    const double rows = static_cast<double>(strips.rows());
    const Index first = static_cast<Index>(from * rows),
                last = std::min(static_cast<Index>(to * rows), strips.rows() - 1);
    consider(from);
    consider(to);
    for (Index g = first; g <= last; ++g) {
      // D_j(x) = p_j + s_j x on the cell; the derivative of the objective is linear in x.
      const double lo = static_cast<double>(g) / rows;
      double constant = 0, slope = 0;
      const double *r0 = strips.row(g), *r1 = strips.row(g + 1);
      for (std::size_t j = 0; j < strips.count(); ++j) {
        const double s = (r1[j] - r0[j]) * rows, p = r0[j] - s * lo;
        constant += s * (2 * p - low[j] - high[j]);
        slope += 2 * s * s;
      }
      if (slope > 0) consider(std::clamp(-constant / slope, std::max(from, lo), std::min(to, lo + 1 / rows)));
    }
    // Rounding must not let E rise: a move has to pay more than the sums' own error.
    if (best < present * (1 - 1e-14) && best_x != knots[i]) {
      largest = std::max(largest, std::abs(best_x - knots[i]));
      knots[i] = best_x;
    }
  }
  return largest;
}

void check_knots(const InteriorKnots& knots) {
  for (const auto* k : {&knots.u, &knots.v})
    for (std::size_t i = 0; i < k->size(); ++i)
      if (!((*k)[i] > (i > 0 ? (*k)[i - 1] : 0.0) && (*k)[i] < 1))
        throw InvalidInput("the criterion needs knots that increase strictly within (0,1)");
}

}  // namespace

double cell_criterion(const FeatureMap& features, const InteriorKnots& knots) {
  validate(features);
  check_knots(knots);
  return energy(Strips(Shares(features, false), knots.v), knots.u);
}

Placement descend_criterion(const FeatureMap& features, InteriorKnots start, double stop, int sweeps) {
  validate(features);
  check_knots(start);
  const Shares along_u(features, false), along_v(features, true);
  Placement result;
  result.knots = std::move(start);
  result.criterion_start = energy(Strips(along_u, result.knots.v), result.knots.u);
  result.status = PlacementStatus::limit;
  for (int s = 0; s < sweeps; ++s) {
    const double move_u = sweep(Strips(along_u, result.knots.v), result.knots.u);
    const double move_v = sweep(Strips(along_v, result.knots.u), result.knots.v);
    if (std::max(move_u, move_v) <= stop) {
      result.status = PlacementStatus::converged;
      break;
    }
  }
  result.criterion = energy(Strips(along_u, result.knots.v), result.knots.u);
  return result;
}

InteriorKnots equal_share(const FeatureMap& features, int interior_u, int interior_v) {
  validate(features);
  if (interior_u < 0 || interior_v < 0)
    throw InvalidInput(
        fmt::format("{} x {} interior knots: neither may be negative", interior_u, interior_v));
  auto direction = [&](bool v, int count) {
    const Index size = v ? features.size_v : features.size_u;
    std::vector<double> breaks(size + 1), mass(size, 0.0);
    for (Index i = 0; i <= size; ++i) breaks[i] = static_cast<double>(i) / static_cast<double>(size);
    for (Index i = 0; i < features.size_u; ++i)
      for (Index j = 0; j < features.size_v; ++j) mass[v ? j : i] += features.f[i * features.size_v + j];
    double total = 0;
    for (double m : mass) total += m;
    if (!(total > 0)) return uniform_knots(count);
    std::vector<double> knots = equal_shares(breaks, mass, count);
    widen_spans(knots, 0.01);  // strips without features leave knots on top of each other
    return knots;
  };
  return {direction(false, interior_u), direction(true, interior_v)};
}

/// Cells of equal feature content [Zhang16]: E(U,V) = sum_ij F_ij^2 -> min, F_ij the integral of the feature measure
/// over cell ij. Steps [METHOD 2.2]; the exact line minimum in place of a search that narrows an interval, the start
/// and the last step are ours:
///  1. start: equal shares of the marginals;
///  2. one knot in turn moves between its neighbours to the exact minimum: the objective is a quadratic between two
///     lines of the measure's grid;
///  3. sweeps over both directions until no knot moves by more than `stop`, or `sweeps` of them: E never rises;
///  4. no span below 1 % of the mean.
Placement place_criterion(PlacementContext& context, int interior_u, int interior_v) {
  const FeatureMap& features = context.features();
  Placement placement = descend_criterion(features, equal_share(features, interior_u, interior_v),
                                          context.options().stop, context.options().sweeps);
  widen_spans(placement.knots.u, 0.01);
  widen_spans(placement.knots.v, 0.01);
  placement.criterion = cell_criterion(features, placement.knots);
  return placement;
}

}  // namespace knotfit
