// Meshes whose vertices at the same place are made one as they are read.
#pragma once
#include <string>

#include "knotfit/source_data.h"
#include "options.h"
namespace knotfit::tool {

/// Drops faces that a mesh has twice, then makes its vertices at the same place one, as --weld says, and notes how many. Parameters of the file are
/// given up only where they differ on both sides of an edge that joins parts of the mesh, and
/// the options do not keep them.
/// \return vertices that went into others
Index weld_input(SourceData& data, const InputOptions& options);

/// For a mesh of several parts: what --weld would join them, as the end of a sentence; empty where none would.
std::string weld_hint(const Mesh& mesh);

}  // namespace knotfit::tool
