// The data energy in the normal equations: its quadratic form and right side, cell by cell.
#pragma once
#include "solve/axis.h"
#include "solve/banded.h"
#include "solve/data_energy.h"
namespace knotfit {

/// The directions of a net as a band matrix has them.
struct NetLayout {
  const Axis& outer;
  const Axis& inner;
  bool swapped;  ///< outer runs along v
};

/// Adds factor times the energy: its matrix, and its goals to the right side.
/// \param right  outer functions x inner functions x dimension
void add_energy(const DataEnergy& energy, const NetLayout& layout, double factor, BandMatrix& matrix,
                std::vector<double>& right);

/// Adds factor times half the energy's gradient at a net to the right side.
/// \param net  size_u x size_v x dimension
void add_energy_gradient(const DataEnergy& energy, const NetLayout& layout, double factor,
                         const std::vector<double>& net, std::vector<double>& right);

}  // namespace knotfit
