// Openings: where a mesh over the unit square has faces that close a gap of the data and are none themselves.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "knotfit/mesh.h"
namespace [[gnu::visibility("default")]] knotfit {

struct Opening {
  std::vector<std::int32_t> faces;  ///< virtual ones, joined by edges
  std::array<double, 3> place{};    ///< middle of its rim, in space
  double length = 0;                ///< of the rim, islands' too
  double share_of_square = 0;       ///< by measure_openings()
};

/// Every part of the virtual faces, the longest rim first. \throws InvalidInput  a corner that is no vertex
std::vector<Opening> find_openings(const Mesh& mesh);

/// Their shares of the square at these parameters. \param uv  2 numbers a vertex
void measure_openings(std::vector<Opening>& openings, const Mesh& mesh, std::span<const double> uv);

/// Share of the square under the faces, without the openings. \param openings  measured at the parameters
double covered_share(const Mesh& mesh, std::span<const double> uv, const std::vector<Opening>& openings);

/// "2 openings beside the rim, at (1, 2, 0) 6.28 around, at (4, 2, 0) 3.14 around": the first five.
std::string describe(const std::vector<Opening>& openings);

}  // namespace knotfit
