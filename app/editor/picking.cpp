#include "app/editor/picking.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "app/editor/messages.h"
#include "sim/geometry/triangle.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/node_report.h"
#include "ui/model/verdict.h"

namespace griffith::app {

namespace {

/// Place where a ray enters a tet.
struct Entry {
  double distance = 0;  ///< in lengths of the ray's direction
  int face = 0;
};

std::array<Vec3, 3> face_corners(const ShownMesh& shown, TetId tet, int face) {
  std::array<Vec3, 3> corners;
  for (int i = 0; i < 3; ++i) corners[i] = shown.positions[shown.frame.elements.tets[tet][kTetFaces[face][i]]];
  return corners;
}

std::optional<Entry> first_entry(const ShownMesh& shown, TetId tet, const Vec3& origin, const Vec3& direction) {
  std::optional<Entry> first;
  for (int face = 0; face < 4; ++face) {
    const auto [a, b, c] = face_corners(shown, tet, face);
    const std::optional<double> distance = triangle_hit(origin, direction, a, b, c);
    if (distance && (!first || *distance < first->distance)) first = Entry{*distance, face};
  }
  return first;
}

}  // namespace

Vec3 seen_weights(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  const Vec3 origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const std::optional<Entry> entry = first_entry(shown, tet, origin, direction);
  if (!entry) return Vec3::Constant(0.25);
  const Vec3 on_face = closest_on_triangle(origin + entry->distance * direction, face_corners(shown, tet, entry->face));
  Vec3 weights = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (const int corner = kTetFaces[entry->face][i]; corner > 0) weights[corner - 1] = on_face[i];
  return weights;
}

double seen_distance(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  const std::optional<Entry> entry = first_entry(shown, tet, ray.origin.cast<double>(), ray.direction.cast<double>());
  return entry ? entry->distance : std::numeric_limits<double>::infinity();
}

NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  const Vec3 origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const std::optional<Entry> entry = first_entry(shown, tet, origin, direction);
  const auto distance = [&](NodeId node) {
    const Vec3 arm = shown.positions[node] - origin;
    return (arm - (entry ? entry->distance : arm.dot(direction)) * direction).norm();
  };
  return *std::ranges::min_element(shown.frame.elements.tets[tet], {}, distance);
}

void select(ui::EditorState& state, const Frame& frame, const ui::Selection& selection) {
  state.selection = selection;
  if (!selection.valid()) return;
  state.selected_body = frame.bodies[frame.elements.bodies[selection.tet]].scene_body;
  state.entries.clear();  // the outliner shows the same body as the other panels
}

void select_node(ui::EditorState& state, const Frame& frame, NodeId node) {
  if (!node.valid() || static_cast<std::size_t>(node) >= frame.nodes.positions.size()) return;
  select(state, frame, ui::select(frame, frame.nodes.stars[node].front(), node));
}

void select_most_loaded(ui::EditorState& state, const Frame& frame) {
  const NodeId node = most_loaded_node(frame);
  if (node.valid()) return select_node(state, frame, node);
  const std::string reason = std::string("No node carries a load: ") + ui::kNothingStrained;
  if (frame.crack_events.empty()) return log_message(state, ui::LogLevel::warning, reason, ui::LogSpan::state);
  select_node(state, frame, frame.crack_events.back().node);
  log_message(state, ui::LogLevel::info, reason + " The node of the last crack is selected.", ui::LogSpan::state);
}

}  // namespace griffith::app
