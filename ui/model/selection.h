#pragma once

#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Material picked in the view: an element, its corner nearest to the cursor, and thereby a piece.
struct Selection {
  TetId tet;
  NodeId node;
  Vec3 rest_position = Vec3::Zero();  ///< rest position of the node, which identifies it after a split [m]

  bool valid() const { return node.valid(); }
  bool operator==(const Selection&) const = default;
};

/// Returns the selection of a tet and one of its nodes.
Selection select(const Frame& frame, TetId tet, NodeId node);

/// Returns the same material in a later frame or in a new run of the scene. The element keeps its id, and its corner
/// with that rest position is the node, or its copy beyond a crack. If remeshing moved the corner to another element,
/// the node's own first element is used. Empty if the material does not exist there.
Selection follow(const Selection& selection, const Frame& frame);

}  // namespace griffith::ui
