// A surface that is there, as any file that holds one.
#pragma once
#include <string>

#include "knotfit/io.h"
#include "options.h"
#include "outputs.h"
namespace knotfit::tool {

/// \param arguments  those of convert \param name  of the surface's file, in a picture's title; may be empty
/// \throws InvalidInput  the file holds no such surface, or needs --cell
void write_converted(const OutputFile& file, bool force, const SurfaceDocument& document,
                     const Arguments& arguments, const std::string& name);

}  // namespace knotfit::tool
