// The data of the tables: the synthetic five, plain and with a hole, clusters or noise; and the truth beside it.
#pragma once
#include <cstdint>
#include <string>

#include "knotfit/fit_surface.h"
#include "knotfit/points.h"
namespace knotfit::bench {

enum class Variant {
  plain,
  hole,      ///< no point in a disk of a fifth of the area, in the middle
  clusters,  ///< density falls from 30 to 1 along u
  noise      ///< normal, standard deviation a fifth of the tolerance of 0.1 % of the diagonal
};
std::string name_of(Variant variant);

struct Data {
  std::string name;
  ParameterizedPoints points;
  double diagonal = 0;  ///< of the box of (u,v,z), or of (x,y,z)
};
Data make_data(const std::string& name, Index count, std::uint64_t seed, Variant variant = Variant::plain);

/// Against the true surface at the centres of 400 x 400 squares.
struct FreshError {
  double all = 0;  ///< largest |S - true| of all places
  double promised =
      0;  ///< of the places that the result promises: error bar at most half the tolerance, no hole
};
FreshError fresh_error(const Surface& surface, const Data& data, double tolerance,
                       const InteriorKnots& metric = {});

/// Processor seconds (user) and wall seconds since it was made.
class Stopwatch {
 public:
  Stopwatch();
  double user() const;
  double wall() const;

 private:
  double user_, wall_;
};

}  // namespace knotfit::bench
