// A surface as a table: values, derivatives, normals and curvatures at places.
#pragma once
#include <string>
#include <vector>

#include "knotfit/io.h"
#include "options.h"
#include "places.h"
namespace knotfit::tool {

/// Named columns of equal length.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  void add(std::string name, std::vector<double> column) {
    names.push_back(std::move(name));
    columns.push_back(std::move(column));
  }
};

/// A header line, then a line a row; numbers are the shortest that read back to the same double.
std::string to_csv(const Table& table);

/// "z"; "x", "y", "z"; "c1", "c2", ... for other dimensions.
std::vector<std::string> component_names(int dimension);

struct SampleOptions {
  std::vector<IntegerPair> derivatives;  ///< by the user's coordinates
  bool normals = false, curvature = false;
};

/// Columns: the places, the values, then what the options ask for.
/// \param uv  parameters of the places
/// \throws InvalidInput  normals or curvature of a surface that is neither in space nor a height field
Table sample(const SurfaceDocument& document, const Places& places, const std::vector<double>& uv,
             const SampleOptions& options);

}  // namespace knotfit::tool
