#include "mesh_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "knotfit/mesh_parameters.h"
#include "text_values.h"
#include "welding.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index kMostMappedWhole = 60000;  // points that are mapped one and all
constexpr Index kMappedSample = 20000;

/// The openings of the data, and the share of the square under the data.
void add_openings(Json& j, const MappedMesh& mapped) {
  j["holes"] = Json::array();
  for (const Opening& o : mapped.openings)
    j["holes"].push_back({{"place", o.place}, {"length", o.length}, {"share_of_square", o.share_of_square}});
  const std::vector<double>& uv = parameters_of(mapped);
  j["covered"] = uv.empty() ? Json(nullptr) : Json(covered_share(mapped.mesh, uv, mapped.openings));
}

/// "holes: 2 without data, ...", or nothing.
std::string holes_text(const MappedMesh& mapped) {
  if (mapped.openings.empty()) return "";
  double share = 0;
  for (const Opening& o : mapped.openings) share += o.share_of_square;
  std::string text =
      fmt::format("holes: {} without data, {:.3g} % of the square", mapped.openings.size(), 100 * share);
  for (std::size_t k = 0; k < mapped.openings.size() && k < 5; ++k) {
    const Opening& o = mapped.openings[k];
    text += fmt::format("; at ({:.8g}, {:.8g}, {:.8g}) {:.4g} around", o.place[0], o.place[1], o.place[2],
                        o.length);
  }
  return text + (mapped.openings.size() > 5 ? "; ...\n" : "\n");
}

Index vertices_of(const MappedMesh& mapped) {
  return mapped.sampled && mapped.sampled->vertices > 0 ? mapped.sampled->vertices
                                                        : mapped.mesh.vertex_count();
}

Index faces_of(const MappedMesh& mapped) {
  return mapped.sampled && mapped.sampled->faces > 0 ? mapped.sampled->faces : mapped.mesh.face_count();
}

/// The number a vertex of a repaired mesh has in its file.
Index number_in_file(const Mesh& mesh, Index vertex) {
  const Index source = mesh.vertex_source.empty() ? vertex : mesh.vertex_source[vertex];
  return source + mesh.counted_from;
}

Index vertex_of_number(const Mesh& mesh, Index number) {
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (number_in_file(mesh, v) == number) return v;
  throw InvalidInput(fmt::format("--corners: there is no vertex {} (counted from {}) in the mesh{}", number,
                                 mesh.counted_from, mesh.vertex_source.empty() ? "" : " after its repair"));
}

Index border_vertex_nearest(const Mesh& mesh, const std::array<double, 3>& place) {
  const MeshTopology topology(mesh);
  Index best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryLoop& loop : topology.loops())
    for (const std::int32_t h : loop.half_edges) {
      const Index v = topology.from(h);
      const double* p = mesh.vertex(v);
      const double d = std::hypot(p[0] - place[0], p[1] - place[1], p[2] - place[2]);
      if (d < least) least = d, best = v;
    }
  return best;
}

MeshMapOptions map_options(const Mesh& mesh, const FitChoices& choices) {
  MeshMapOptions options;
  options.omega = choices.omega.value_or(-1);
  const CornerChoice corners = parse_corners(choices.corners.value_or("auto"));
  options.corners = corners.rule;
  if (!corners.vertices.empty()) {
    options.corner_vertices.emplace();
    for (std::size_t k = 0; k < 4; ++k)
      (*options.corner_vertices)[k] = vertex_of_number(mesh, corners.vertices[k]);
  } else if (!corners.places.empty()) {
    options.corner_vertices.emplace();
    for (std::size_t k = 0; k < 4; ++k)
      (*options.corner_vertices)[k] = border_vertex_nearest(mesh, corners.places[k]);
  }
  return options;
}

std::vector<double> vertices_without_faces(const Mesh& mesh) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const auto& face : mesh.faces)
    for (const std::int32_t v : face) used[v] = 1;
  std::vector<double> loose;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (used[v] == 0) loose.insert(loose.end(), mesh.vertex(v), mesh.vertex(v) + 3);
  return loose;
}

/// The map of a sample of its vertices, where those that are wanted as corners stay.
void map_some(MappedMesh& mapped, Index most, const FitChoices& choices, const Control& control) {
  auto sampled = std::make_shared<Sampled>();
  sampled->most = most;
  sampled->vertices = mapped.mesh.vertex_count();
  sampled->faces = mapped.mesh.face_count();
  sampled->line = table_of(mapped.mesh).line;
  sampled->source = mesh_source(mapped.mesh, [choices, control](const Mesh& mesh) {
    return parameterize_mesh(mesh, map_options(mesh, choices), control);
  });
  sampled->map = map_sample(sampled->source, most);
  sampled->loose = mapped.loose;
  const std::vector<double>& points = sampled->source.points;
  std::vector<char> there(points.size() / 3, 0);
  for (const Index number : sampled->map.mesh.vertex_line)
    if (number > 0) there[number - 1] = 1;
  for (std::size_t k = 0; k < there.size(); ++k)
    if (there[k] == 0) mapped.loose.insert(mapped.loose.end(), &points[3 * k], &points[3 * k] + 3);
  take_map(mapped, sampled->map, sampled->line);
  mapped.sampled = std::move(sampled);
}

}  // namespace

Index sample_of(Index count, const FitChoices& choices) {
  const Engine engine = choices.engine.value_or(Engine::automatic);
  if (engine == Engine::points) return 0;
  return count > (engine == Engine::sample ? kMappedSample : kMostMappedWhole) ? kMappedSample : 0;
}

void take_map(MappedMesh& mapped, CloudMap map, const std::vector<Index>& line) {
  mapped.mesh = std::move(map.mesh);
  mapped.map = std::move(map.map);
  for (Index& k : mapped.mesh.vertex_line)
    if (k > 0 && !line.empty()) k = line[k - 1];
  map.mesh = {};
  map.map = {};
  if (!mapped.cloud) {
    mapped.openings = find_openings(mapped.mesh);
    measure_openings(mapped.openings, mapped.mesh, mapped.map->uv);
    return;
  }
  mapped.openings = map.openings;
  mapped.cloud = std::move(map);
}

MappedMesh repaired_mesh(const Mesh& mesh, const FitChoices& choices) {
  RepairedMesh repaired = repair(mesh, {.largest_part = choices.largest_part.value_or(false),
                                        .fill_holes = choices.fill_holes.value_or(false),
                                        .orient = choices.orient.value_or(false),
                                        .drop_degenerate = choices.drop_degenerate.value_or(false)});
  MappedMesh mapped{.mesh = std::move(repaired.mesh), .repaired = repaired.summary, .map = std::nullopt};
  mapped.loose = vertices_without_faces(mesh);
  mapped.openings = find_openings(mapped.mesh);
  if (!mapped.mesh.uv.empty()) measure_openings(mapped.openings, mapped.mesh, mapped.mesh.uv);
  return mapped;
}

const std::vector<double>& parameters_of(const MappedMesh& mapped) {
  return mapped.map ? mapped.map->uv : mapped.mesh.uv;
}

MappedMesh map_mesh(const Mesh& mesh, const FitChoices& choices, const Control& control, bool newton,
                    bool sampled) {
  MappedMesh mapped = repaired_mesh(mesh, choices);
  if (!mapped.mesh.uv.empty() && !choices.new_parameters.value_or(false)) {
    ParameterCheck check = check_parameters(mapped.mesh);
    if (check.one_to_one) return mapped;
    mapped.left_aside = std::move(check.why);
  }
  mapped.mesh.uv.clear();
  try {
    require_disk(mapped.mesh);
  } catch (const InvalidInput& e) {
    const std::string hint = weld_hint(mapped.mesh);
    if (mapped.left_aside.empty() && hint.empty()) throw;
    if (mapped.left_aside.empty()) throw InvalidInput(e.what() + hint);
    throw InvalidInput(
        fmt::format("the mesh's parameters (texture coordinates) are no parameters of a surface, {}, "
                    "and a map of it is not to be had: {}",
                    mapped.left_aside, e.what() + hint));
  }
  if (const Index most = sampled ? sample_of(mapped.mesh.vertex_count(), choices) : 0; most > 0) {
    map_some(mapped, most, choices, control);
    return mapped;
  }
  MeshMapOptions options = map_options(mapped.mesh, choices);
  options.newton = newton;
  mapped.map = parameterize_mesh(mapped.mesh, options, control);
  measure_openings(mapped.openings, mapped.mesh, mapped.map->uv);
  return mapped;
}

PointTable table_of(const Mesh& mesh) {
  std::vector<char> real(static_cast<std::size_t>(mesh.vertex_count()), 1);
  if (!mesh.virtual_face.empty()) {
    std::fill(real.begin(), real.end(), 0);
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (const std::int32_t v : mesh.faces[f]) real[v] |= static_cast<char>(!mesh.virtual_face[f]);
  }
  PointTable table;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!real[v]) continue;
    table.x.push_back(mesh.vertex(v)[0]);
    table.y.push_back(mesh.vertex(v)[1]);
    table.z.push_back(mesh.vertex(v)[2]);
    if (!mesh.uv.empty()) {
      table.u.push_back(mesh.uv[2 * v]);
      table.v.push_back(mesh.uv[2 * v + 1]);
    }
    table.line.push_back(mesh.vertex_line.empty() ? number_in_file(mesh, v) + 1 - mesh.counted_from
                                                  : mesh.vertex_line[v]);
  }
  return table;
}

std::string mesh_to_text(const MappedMesh& mapped) {
  if (mapped.cloud) return "base: " + describe(*mapped.cloud) + "\n" + holes_text(mapped);
  const RepairSummary& r = mapped.repaired;
  std::string text = fmt::format("mesh: {} vertices, {} triangles", vertices_of(mapped), faces_of(mapped));
  if (mapped.sampled)
    text += fmt::format(", of which a sample of {} vertices is mapped", mapped.sampled->map.sample);
  const std::pair<Index, const char*> counts[] = {{r.dropped_parts, "parts dropped"},
                                                  {r.dropped_faces, "triangles dropped"},
                                                  {r.turned_faces, "triangles turned"},
                                                  {r.filled_holes, "holes filled"},
                                                  {r.dropped_vertices, "vertices dropped"}};
  for (const auto& [count, what] : counts)
    if (count > 0) text += fmt::format(", {} {}", count, what);
  text += "\n" + holes_text(mapped);
  if (!mapped.map)
    return text +
           (mapped.mesh.uv.empty() ? "" : "parameters: the file's own (texture coordinates), one-to-one\n");
  const MeshMap& map = *mapped.map;
  const MapQuality& q = map.quality;
  text += fmt::format(
      "map: L2 stretch {:.4g} ({:.4g} on a rectangle {:.3g} : 1), worst angle {:.3g} degrees, {} flipped; "
      "normals "
      "weighted {:g}\n",
      q.stretch, q.aspect_free_stretch, q.aspect, q.worst_angle, q.flipped, map.omega);
  return text + fmt::format("corners: vertices {}, {}, {}, {} (counted from {})\n",
                            number_in_file(mapped.mesh, map.corners[0]),
                            number_in_file(mapped.mesh, map.corners[1]),
                            number_in_file(mapped.mesh, map.corners[2]),
                            number_in_file(mapped.mesh, map.corners[3]), mapped.mesh.counted_from);
}

std::string mesh_to_json(const MappedMesh& mapped) {
  const RepairSummary& r = mapped.repaired;
  Json j = {{"vertices", vertices_of(mapped)},
            {"triangles", faces_of(mapped)},
            {"sample", mapped.sampled ? mapped.sampled->map.sample : 0},
            {"dropped_parts", r.dropped_parts},
            {"dropped_faces", r.dropped_faces},
            {"turned_faces", r.turned_faces},
            {"filled_holes", r.filled_holes},
            {"dropped_vertices", r.dropped_vertices},
            {"map", nullptr}};
  j["parameters"] = mapped.map ? Json("map") : mapped.mesh.uv.empty() ? Json(nullptr) : Json("file");
  j["left_aside"] = mapped.left_aside.empty() ? Json(nullptr) : Json(mapped.left_aside);
  add_openings(j, mapped);
  if (mapped.map) {
    const MeshMap& map = *mapped.map;
    Json corners = Json::array();
    for (const Index v : map.corners) corners.push_back(number_in_file(mapped.mesh, v));
    const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
    j["map"] = {{"corners", corners},
                {"counted_from", mapped.mesh.counted_from},
                {"omega", number(map.omega)},
                {"stretch", number(map.quality.stretch)},
                {"aspect_free_stretch", number(map.quality.aspect_free_stretch)},
                {"aspect", number(map.quality.aspect)},
                {"worst_angle", number(map.quality.worst_angle)},
                {"flipped", map.quality.flipped},
                {"trial_error", number(map.trial_error)},
                {"trial_distance", number(map.trial_distance)},
                {"stopped", map.stopped}};
  }
  return j.dump();
}

std::string cloud_to_json(const MappedMesh& mapped) {
  const CloudMap& cloud = *mapped.cloud;
  std::vector<Index> stray_rows;  // from 1, as in the description
  for (const Index r : cloud.stray_rows) stray_rows.push_back(r + 1);
  Json j = {{"base", name_of(kBases, cloud.base)},
            {"description", describe(cloud)},
            {"points", cloud.points},
            {"sample", cloud.sample},
            {"coincident", cloud.coincident},
            {"lone", cloud.lone},
            {"stray_rows", stray_rows},
            {"normals", cloud.normals},
            {"folded", cloud.folded},
            {"mapped", cloud.mapped}};
  add_openings(j, mapped);
  if (cloud.base == CloudBase::plane || cloud.base == CloudBase::cylinder) {
    j["centre"] = cloud.centre;
    j["axis"] = cloud.axis;
    j["scatter"] = cloud.scatter;
  }
  if (cloud.base == CloudBase::cylinder) j["radius"] = cloud.radius;
  return j.dump();
}

}  // namespace knotfit::tool
