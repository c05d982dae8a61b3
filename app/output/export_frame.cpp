#include "app/output/export_frame.h"

#include "app/output/file_formats.h"
#include "app/picture/quantities.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/mesh/write_mesh.h"

namespace griffith::app {
namespace {

/// Arrays that a frame lacks in the form of a file; they must outlive the fields that refer to them. Points are the
/// nodes, then the midpoints of the edges of quadratic tets.
struct ExportArrays {
  std::vector<Vec3> positions, displacements, velocities, reactions, separation_directions;
  std::vector<std::array<std::int32_t, 6>> middles;
  std::vector<double> separation_stresses, resistances, utilizations, von_mises;
  std::vector<std::int32_t> bodies, scene_bodies;
};

/// Appends the means of edges' end values to values of nodes.
template <class T>
void append_means(const Frame& frame, std::vector<T>& values) {
  for (const auto& [a, b] : frame.edges.ends) values.push_back(0.5 * (values[a] + values[b]));
}

void append_middles(const Frame& frame, ExportArrays& arrays) {
  const auto nodes = static_cast<std::int32_t>(arrays.positions.size());
  for (std::vector<Vec3>* values :
       {&arrays.positions, &arrays.displacements, &arrays.velocities, &arrays.reactions, &arrays.separation_directions})
    append_means(frame, *values);
  for (std::vector<double>* values : {&arrays.separation_stresses, &arrays.resistances, &arrays.utilizations})
    append_means(frame, *values);
  for (std::size_t i = 0; i < frame.edges.offsets.size(); ++i) {
    arrays.positions[nodes + i] += frame.edges.offsets[i];
    arrays.displacements[nodes + i] += frame.edges.offsets[i];
  }
  for (const std::array<EdgeId, 6>& edges : frame.elements.edges) {
    std::array<std::int32_t, 6>& of_tet = arrays.middles.emplace_back();
    for (int i = 0; i < 6; ++i) of_tet[i] = edges[i].valid() ? nodes + edges[i].index() : -1;
  }
}

ExportArrays arrays_of(const Frame& frame) {
  ExportArrays arrays;
  arrays.positions.assign(frame.nodes.positions.begin(), frame.nodes.positions.end());
  arrays.velocities.assign(frame.nodes.velocities.begin(), frame.nodes.velocities.end());
  arrays.reactions.assign(frame.nodes.reactions.begin(), frame.nodes.reactions.end());
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const NodeSeparation& separation = frame.nodes.separations[i];
    arrays.displacements.push_back(frame.nodes.positions[i] - frame.nodes.rest_positions[i]);
    arrays.separation_directions.push_back(separation.direction);
    arrays.separation_stresses.push_back(separation.stress);
    arrays.resistances.push_back(separation.resistance);
    arrays.utilizations.push_back(separation.utilization);
  }
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i) {
    const BodyId body = frame.elements.bodies[i];
    arrays.von_mises.push_back(von_mises_stress(frame.elements.stresses[i]));
    arrays.bodies.push_back(body.index());
    arrays.scene_bodies.push_back(frame.bodies[body].scene_body);
  }
  if (!frame.edges.ends.empty()) append_middles(frame, arrays);
  return arrays;
}

void export_vtu(const std::filesystem::path& path, const Frame& frame) {
  const ExportArrays arrays = arrays_of(frame);
  const auto doubles = [](const std::vector<double>& values) { return std::span<const double>(values); };
  const auto vectors = [](const std::vector<Vec3>& values) { return std::span<const Vec3>(values); };
  const auto ids = [](const std::vector<std::int32_t>& values) { return std::span<const std::int32_t>(values); };
  VtuFields fields;
  fields.per_node = {{"displacement [m]", vectors(arrays.displacements)},
                     {"velocity [m/s]", vectors(arrays.velocities)},
                     {"reaction [N]", vectors(arrays.reactions)},
                     {"separation_stress [Pa]", doubles(arrays.separation_stresses)},
                     {"resistance [Pa or N]", doubles(arrays.resistances)},
                     {"utilization", doubles(arrays.utilizations)},
                     {"separation_direction", vectors(arrays.separation_directions)}};
  fields.per_tet = {{"stress [Pa]", frame.elements.stresses},
                    {"von_mises [Pa]", doubles(arrays.von_mises)},
                    {"body", ids(arrays.bodies)},
                    {"scene_body", ids(arrays.scene_bodies)}};
  write_vtu(path, arrays.positions, frame.elements.tets, fields, arrays.middles);
}

void export_gmsh(const std::filesystem::path& path, const Frame& frame) {
  TetSoup soup;
  soup.points.assign(frame.nodes.positions.begin(), frame.nodes.positions.end());
  for (const auto& [a, b, c, d] : frame.elements.tets)
    soup.tets.push_back({a.index(), b.index(), c.index(), d.index()});
  write_gmsh(path, soup);
}

struct FrameFormat {
  std::string_view extension;
  std::string_view content;
  void (*write)(const std::filesystem::path&, const Frame&);
};

constexpr FrameFormat kFrameFormats[] = {{".vtu", "ParaView", export_vtu}, {".msh", "Gmsh", export_gmsh}};

}  // namespace

std::string frame_formats_text() { return formats_text(kFrameFormats); }

void check_export_path(const std::filesystem::path& path) { format_of(kFrameFormats, path); }

void export_frame(const std::filesystem::path& path, const Frame& frame) {
  format_of(kFrameFormats, path).write(path, frame);
}

}  // namespace griffith::app
