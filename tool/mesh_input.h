// Meshes on their way to points with parameters: repaired, checked, mapped.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "knotfit/control.h"
#include "knotfit/fit_sample.h"
#include "knotfit/mesh.h"
#include "knotfit/openings.h"
#include "knotfit/parameterize_cloud.h"
#include "knotfit/parameterize_mesh.h"
#include "knotfit/source_data.h"
#include "options.h"
namespace knotfit::tool {

/// Points, or a mesh's vertices, of which a sample was mapped.
struct Sampled {
  SampleSource source;
  std::vector<Index> line;         ///< of each point in the file; empty: its number
  Index most = 0;                  ///< points of the sample
  CloudMap map;                    ///< of the sample, with numbers of points from 1 as its vertex_line
  Index vertices = 0, faces = 0;   ///< of the whole mesh
  std::vector<double> loose = {};  ///< n x 3, no points of the source: vertices without faces
};

/// A mesh as it was mapped.
struct MappedMesh {
  Mesh mesh;  ///< repaired
  RepairSummary repaired;
  std::optional<MeshMap> map;  ///< absent: the parameters of the file are used, or none are needed
  std::string left_aside =
      {};  ///< why the parameters of the file are not used; empty: they are, or it has none
  /// Where the input was no mesh but points: what they were laid over. Its mesh and map are those above.
  std::optional<CloudMap> cloud = {};
  std::shared_ptr<const Sampled> sampled = {};  ///< where a sample was mapped
  std::vector<double> loose = {};               ///< points that no triangle of what was mapped has, n x 3
  std::vector<double> loose_uv = {}, loose_distance = {};  ///< their feet on the surface, once it is there
  std::vector<Opening> openings =
      {};  ///< of the data, closed by virtual faces; shares at the map's parameters
};

/// Points of the sample that is mapped, as --engine asks, of `count`; 0: all are.
Index sample_of(Index count, const FitChoices& choices);

/// Mesh, map and openings are those of `map`, and the rest of it where the input was no mesh. \param line  of each point in the
/// file; empty: its number
void take_map(MappedMesh& mapped, CloudMap map, const std::vector<Index>& line);

/// Repairs the mesh as asked.
MappedMesh repaired_mesh(const Mesh& mesh, const FitChoices& choices);

/// Repairs the mesh, and maps it unless it has parameters that are wanted and one-to-one.
/// \throws InvalidInput  no disk, corners that are none
/// \param newton  false: the mean value map alone
/// \param sampled  of more than 60 000 vertices, or as --engine asks, a sample is mapped
MappedMesh map_mesh(const Mesh& mesh, const FitChoices& choices, const Control& control, bool newton = true,
                    bool sampled = false);

/// Vertices as points, with the parameters of the file where it has some; those that only close holes are
/// left out.
PointTable table_of(const Mesh& mesh);

/// What a report says of the map, as sentences and as the text of a JSON object.
std::string mesh_to_text(const MappedMesh& mapped);
std::string mesh_to_json(const MappedMesh& mapped);
std::string cloud_to_json(const MappedMesh& mapped);

/// The mesh's parameters where it was mapped, else its own.
const std::vector<double>& parameters_of(const MappedMesh& mapped);

}  // namespace knotfit::tool
