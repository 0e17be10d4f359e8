// Surfaces as STEP and IGES files.
#pragma once
#include "options.h"
#include "outputs.h"
namespace knotfit::tool {

/// Before long work: what write_cad_file would refuse.
/// \throws InvalidInput  neither in space nor a height field
void check_cad_output(const OutputFile& file, int dimension, bool height_field);

/// The surface in space, one face, or those of cad_safe.
/// \throws InvalidInput  no CAD file holds it, or cad_safe's tolerance does not allow it
void write_cad_file(const OutputFile& file, bool force, const Surface& surface, const ParameterMap& map,
                    bool height_field, const CadChoices& choices);

}  // namespace knotfit::tool
