// Files of other programs that are not read: told by their first bytes, with the command that makes one that is.
#pragma once
#include <string>
#include <string_view>

#include "formats/file_bytes.h"
namespace knotfit {

/// How many of its first bytes tell what a file is, archives apart.
inline constexpr std::size_t kForeignBytes = 4096;

/// "is a GeoTIFF raster, which this version does not read; convert it: gdal_translate ..." for the file at `path` that
/// begins with `bytes`; empty where it is none of these. Archives are told apart by the names in them.
std::string foreign_file(std::string_view bytes, const std::string& path);

/// The same by the extension of the path alone, for files whose bytes tell nothing.
std::string foreign_extension(const std::string& path);

/// \throws FileError  foreign_file says that it is one
void refuse_foreign(const FileBytes& file);

}  // namespace knotfit
