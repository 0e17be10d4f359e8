// Whether a surface keeps to its data between points that stand side by side, and in the gaps.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "data/indexed_points.h"
#include "knotfit/verify.h"
namespace knotfit::verify {

/// Places inside small triangles of neighbours and in gaps, with what the data about them allows: made once, asked of
/// many surfaces. Threaded over places; the same for any number of threads.
class SwingSites {
 public:
  /// \param points       outlive the sites
  /// \param most_places  about so many inside triangles
  /// \param indexed      the points, where they are; null: made here
  SwingSites(const ParameterizedPoints& points, Index most_places,
             std::shared_ptr<const IndexedPoints> indexed = {}, unsigned long long seed = 1);

  /// The points, for others that look about a place.
  const std::shared_ptr<const IndexedPoints>& indexed() const { return indexed_; }

  /// \param errors     n, |S - P| of every point
  /// \param tolerance  > 0: swings are in units of the larger of it and the largest error of the 8 nearest points
  SwingReport measure(const Surface& surface, const std::vector<double>& errors, double tolerance) const {
    return measure(surface, errors, tolerance, nullptr);
  }
  /// Where a surface goes too far, and the nearest value that the data about allows there.
  struct Strays {
    std::vector<double> uv, values;  ///< n x 2, n x dimension
  };
  /// Likewise, with the places beyond half of what is allowed.
  SwingReport measure(const Surface& surface, const std::vector<double>& errors, double tolerance,
                      Strays* strays) const;

 private:
  /// A place with the corners of its small triangle; none: it lies in a gap.
  struct Place {
    double u, v;
    std::array<Index, 3> corners{-1, -1, -1};
    bool in_gap() const { return corners[0] < 0; }
  };
  struct Sites;
  Sites sites(const std::vector<Place>& places) const;
  /// Whether two of these points lie in each quarter about a place.
  bool on_every_side(double u, double v, const std::vector<std::uint32_t>& index) const;
  /// Pairs of neighbours that make a small triangle with point k, one after the other around it.
  std::vector<Index> ring(Index k) const;
  /// The place in its small triangle, or in none: a gap.
  Place located(double u, double v) const;
  /// A crest between points leaves their box, and the data says so itself: places where the surface is as near to the local
  /// reference as swings may be are none.
  void excuse(const Sites& sites, const std::vector<double>& at, const std::vector<double>& errors,
              double tolerance, std::vector<double>& ratio) const;
  void count(SwingReport& report, const Sites& sites, const Surface& surface,
             const std::vector<double>& errors, double tolerance, Strays* strays) const;
  /// \return whether it goes farther beyond the data's box than is allowed and the data about explains
  bool measure_box(SwingReport& report, const Surface& surface, double allowed, Strays* strays) const;

  const ParameterizedPoints& points_;
  std::shared_ptr<const IndexedPoints> indexed_;
  const DistinctPoints& distinct_;
  const Neighbours& neighbours_;
  std::vector<double> low_, high_;  ///< box of all values
  double diagonal_ = 0;
  std::shared_ptr<const Sites> fixed_;
};

}  // namespace knotfit::verify
