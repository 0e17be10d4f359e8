// Points without a mesh on their way to one: clouds over a base, rows and points whose parameters are corrected.
#pragma once
#include "knotfit/control.h"
#include "knotfit/points.h"
#include "knotfit/source_data.h"
#include "mesh_input.h"
#include "options.h"
namespace knotfit::tool {

/// Points in space as a mesh over the base that --base names; of more than 60 000, or as --engine asks, a sample.
/// \throws InvalidInput  no x, y; what the base cannot carry
MappedMesh map_cloud(const PointTable& table, const FitChoices& choices, const Control& control);

/// Points that have parameters as a mesh at these; with --new-parameters, and in rows where that can be, at those of a map
/// of the mesh.
/// \param in_rows  of different lengths, one after the other
MappedMesh map_points(const ParameterizedPoints& points, bool in_rows, const FitChoices& choices,
                      const Control& control);

}  // namespace knotfit::tool
