// From a data file to points with parameters.
#pragma once
#include <optional>
#include <string>

#include "knotfit/io.h"
#include "knotfit/points.h"
#include "knotfit/source_data.h"
#include "mesh_input.h"
#include "options.h"
#include "reading.h"
namespace knotfit::tool {

/// What a report says of the input.
struct InputSummary {
  std::string path, format;
  Index points = 0;      ///< fitted
  Index holes = 0;       ///< cells or points without data
  Reading reading;       ///< what was done with the file
  Index duplicates = 0;  ///< points dropped since others have their parameters
  Index welded = 0;      ///< vertices of a mesh that went into others at their place
};

struct FitInput {
  InputSummary summary;
  ParameterizedPoints points;
  /// The points before duplicates were settled; empty where none was dropped.
  ParameterizedPoints all_points;
  std::optional<Raster> raster;    ///< the input itself, where it is one
  std::optional<MappedMesh> mesh;  ///< the input, where it is a mesh
  const ParameterizedPoints& every_point() const { return all_points.size() > 0 ? all_points : points; }
};

/// The tool's options as the library's.
ReadOptions read_options(const InputOptions& options);
/// read_data with the tool's options, and of "-" standard input; vertices of meshes at the same place made one.
/// \param places  z may be missing, as ReadOptions::places
/// \param welded  how many vertices went into others
SourceData read_input(const std::string& path, const InputOptions& options, bool places = false,
                      Index* welded = nullptr);

/// read_data, and of "-" standard input.
SourceData read_source(const std::string& path, const ReadOptions& options);

/// \param choices  completed: tolerance present unless a size or knots make it absent
/// \throws FileError, InvalidInput  the message begins with the path
FitInput read_fit_input(const std::string& path, const FitChoices& choices, const Control& control = {});

/// From what was read, or was in memory: what read_fit_input() does with it.
/// \param data    its vertices welded \param welded  how many went into others
/// \throws InvalidInput  without the input's name
FitInput fit_input_of(SourceData data, Index welded, const FitChoices& choices, const Control& control);
/// Points that have their parameters. \param points  valid (validate()) \param name  of the input, in a report
FitInput fit_input_of(ParameterizedPoints points, const std::string& name, const FitChoices& choices);

/// Cells or points of `data` that are holes.
Index count_holes(const SourceData& data);

/// Rows, or the cells of a raster, as a table of points, holes left out.
PointTable table_of(const PointRows& rows);
PointTable table_of(const Raster& raster);

}  // namespace knotfit::tool
