#include "app/editor/picking.h"

#include <algorithm>
#include <optional>
#include <string>

#include "app/editor/messages.h"
#include "sim/geometry/triangle.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/output/node_report.h"
#include "ui/model/verdict.h"

namespace griffith::app {

NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  const Vec3 origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const auto corner = [&](int i) { return shown.positions[shown.frame.elements.tets[tet][i]]; };
  std::optional<double> entry;
  for (const auto& face : kTetFaces) {
    const std::optional<double> t = triangle_hit(origin, direction, corner(face[0]), corner(face[1]), corner(face[2]));
    if (t && (!entry || *t < *entry)) entry = t;
  }
  const auto distance = [&](NodeId node) {
    const Vec3 arm = shown.positions[node] - origin;
    return (arm - entry.value_or(arm.dot(direction)) * direction).norm();
  };
  return *std::ranges::min_element(shown.frame.elements.tets[tet], {}, distance);
}

void select(ui::EditorState& state, const Frame& frame, const ui::Selection& selection) {
  state.selection = selection;
  if (selection.valid()) state.selected_body = frame.bodies[frame.elements.bodies[selection.tet]].scene_body;
}

void select_node(ui::EditorState& state, const Frame& frame, NodeId node) {
  if (!node.valid() || static_cast<std::size_t>(node) >= frame.nodes.positions.size()) return;
  select(state, frame, ui::select(frame, frame.nodes.stars[node].front(), node));
}

void select_most_loaded(ui::EditorState& state, const Frame& frame) {
  const NodeId node = most_loaded_node(frame);
  if (node.valid()) return select_node(state, frame, node);
  log_message(state, ui::LogLevel::warning, std::string("No node carries a load: ") + ui::kNothingStrained,
              ui::LogSpan::state);
}

}  // namespace griffith::app
