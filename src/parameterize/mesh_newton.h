// Projected Newton: the map of least stretch on the best rectangle, border vertices sliding.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "parameterize/mesh_factor.h"
#include "parameterize/mesh_rest.h"
namespace knotfit::mesh_map {

/// Brings down sum_T A (1/s1^2 + 1/s2^2 + theta (s1^2 + s2^2)) / sum A on a rectangle of the rest
/// area, whose aspect is renewed each round. Border vertices keep their side and slide along it;
/// corners stay. No triangle ever turns over.
class NewtonMap {
 public:
  /// \param uv  a map onto the unit square without a flat or turned triangle
  NewtonMap(const DiskMesh& disk, const std::vector<RestTriangle>& rest, const Elimination& elimination,
            std::vector<double> uv);
  /// At most `rounds` more; ends where the energy falls by less than `tolerance` of itself.
  void advance(int rounds, double tolerance = 1e-4, const std::function<bool()>& stop = {});
  /// Frees what one round leaves for the next; advance() works on.
  void release();
  bool converged() const { return converged_; }
  int rounds() const { return rounds_; }
  double energy() const { return energy_; }
  double aspect() const { return aspect_; }  ///< width over height of the rectangle
  /// On the unit square; boundary vertices exactly on their sides.
  std::vector<double> square_parameters() const;

 private:
  void round(double tolerance);
  double energy_at(std::span<const double> plane) const;
  void assemble();
  bool factor();
  double first_flattening(std::span<const double> direction) const;
  bool step(std::span<const double> direction);
  void renew_aspect();
  double width() const;
  double height() const;

  const DiskMesh& disk_;
  const std::vector<RestTriangle>& rest_;
  BlockCholesky cholesky_;
  std::vector<char> fixed_;
  std::vector<double> plane_;  ///< parameters on the rectangle
  double area_ = 0, aspect_ = 1, energy_ = 0;
  std::vector<double> gradient_, diagonal_, off_;
  bool converged_ = false;
  int rounds_ = 0;
};

}  // namespace knotfit::mesh_map
