// One reader a format; registry.cpp is the table of them.
#pragma once
#include <string>

#include "formats/file_bytes.h"
#include "knotfit/io.h"
namespace knotfit {

/// Each reads a whole file of its format. \throws FileError  malformed; InvalidInput  options
SourceData read_esri_ascii(const FileBytes& file, const ReadOptions& options);
SourceData read_csv(const FileBytes& file, const ReadOptions& options);
SourceData read_rows(const FileBytes& file, const ReadOptions& options);
/// Points in text: rows where groups of three columns without a header are parted by blank lines,
/// a table otherwise.
SourceData read_text_points(const FileBytes& file, const ReadOptions& options);
SourceData read_npy(const FileBytes& file, const ReadOptions& options);
/// Meshes; points where the file has no faces.
SourceData read_ply(const FileBytes& file, const ReadOptions& options);
SourceData read_obj(const FileBytes& file, const ReadOptions& options);
SourceData read_off(const FileBytes& file, const ReadOptions& options);
SourceData read_stl(const FileBytes& file, const ReadOptions& options);
/// Points of laser scanners; all but those marked as withheld, or those of the classes and returns asked for.
SourceData read_las(const FileBytes& file, const ReadOptions& options);
/// Points; rows of points where the file has more than one row, with holes where the scanner saw nothing.
SourceData read_pcd(const FileBytes& file, const ReadOptions& options);

/// read_data on bytes already in memory: the format from options, else from the path's extension,
/// else from the content.
SourceData read_bytes(const FileBytes& file, const ReadOptions& options);

/// The text begins with a keyword of an ESRI ASCII grid.
bool looks_like_esri_ascii(std::string_view text);

}  // namespace knotfit
