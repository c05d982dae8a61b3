#include "app/output/export_frame.h"

#include "app/output/file_formats.h"
#include "sim/mesh/write_mesh.h"
#include "sim/world/output/quantity_values.h"

namespace griffith::app {
namespace {

/// Returns the nodes, then the midpoints of the edges of quadratic tets.
std::vector<Vec3> points_of(const Frame& frame) {
  std::vector<Vec3> points(frame.nodes.positions.begin(), frame.nodes.positions.end());
  for (std::size_t i = 0; i < frame.edges.ends.size(); ++i) {
    const auto [a, b] = frame.edges.ends[i];
    points.push_back(0.5 * (points[a] + points[b]) + frame.edges.offsets[i]);
  }
  return points;
}

/// Returns, per tet, the points in the middle of its edges; -1 for a linear one. Empty: all are linear.
std::vector<std::array<std::int32_t, 6>> middles_of(const Frame& frame) {
  const auto nodes = static_cast<std::int32_t>(frame.nodes.positions.size());
  std::vector<std::array<std::int32_t, 6>> middles;
  if (frame.edges.ends.empty()) return middles;
  for (const std::array<EdgeId, 6>& edges : frame.elements.edges) {
    std::array<std::int32_t, 6>& of_tet = middles.emplace_back();
    for (int i = 0; i < 6; ++i) of_tet[i] = edges[i].valid() ? nodes + edges[i].index() : -1;
  }
  return middles;
}

/// Returns the name of an array in a file: "von_mises [Pa]".
std::string field_name(const Quantity& quantity) {
  const bool has_unit = !quantity.unit.empty() && quantity.unit != "-";
  return std::string(quantity.key) + (has_unit ? " [" + std::string(quantity.unit) + "]" : "");
}

MeshField field_of(const std::string& name, const QuantityArray& values) {
  return std::visit([&](const auto& array) { return MeshField{name, std::span(array)}; }, values);
}

void export_vtu(const std::filesystem::path& path, const Frame& frame) {
  std::vector<std::int32_t> bodies, scene_bodies;
  for (const BodyId body : frame.elements.bodies) {
    bodies.push_back(body.index());
    scene_bodies.push_back(frame.bodies[body].scene_body);
  }
  const std::vector<const Quantity*> quantities = file_quantities();
  std::vector<QuantityArray> arrays;  // the fields refer to them
  for (const Quantity* quantity : quantities) arrays.push_back(quantity_array(frame, *quantity));
  VtuFields fields;
  for (std::size_t i = 0; i < quantities.size(); ++i)
    (place_of(*quantities[i]) == ValuePlace::node ? fields.per_node : fields.per_tet)
        .push_back(field_of(field_name(*quantities[i]), arrays[i]));
  fields.per_tet.push_back({"body", std::span<const std::int32_t>(bodies)});
  fields.per_tet.push_back({"scene_body", std::span<const std::int32_t>(scene_bodies)});
  write_vtu(path, points_of(frame), frame.elements.tets, fields, middles_of(frame));
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
