#include "ui/model/selection.h"

#include <algorithm>

namespace griffith::ui {

Selection select(const Frame& frame, TetId tet, NodeId node) { return {tet, node, frame.nodes.rest_positions[node]}; }

Selection follow(const Selection& selection, const Frame& frame) {
  if (!selection.valid()) return {};
  if (selection.tet.valid() && static_cast<std::size_t>(selection.tet) < frame.elements.tets.size()) {
    for (NodeId corner : frame.elements.tets[selection.tet])
      if (frame.nodes.rest_positions[corner] == selection.rest_position) return select(frame, selection.tet, corner);
  }
  NodeId node = selection.node;
  if (static_cast<std::size_t>(node) >= frame.nodes.positions.size() ||
      frame.nodes.rest_positions[node] != selection.rest_position) {
    const auto found = std::ranges::find(frame.nodes.rest_positions, selection.rest_position);
    if (found == frame.nodes.rest_positions.end()) return {};
    node = NodeId(found - frame.nodes.rest_positions.begin());
  }
  return select(frame, frame.nodes.stars[node].front(), node);
}

}  // namespace griffith::ui
