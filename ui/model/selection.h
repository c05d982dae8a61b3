#pragma once

#include "sim/world/frame.h"

namespace griffith::ui {

/// What was picked in the view: an element, the corner of it that is nearest to the cursor and, through them, a piece.
struct Selection {
  TetId tet;
  NodeId node;
  Vec3 rest_position = Vec3::Zero();  ///< of the node [m]: by it the node is known again after a split

  bool valid() const { return node.valid(); }
  bool operator==(const Selection&) const = default;
};

/// The selection of a tet and one of its nodes.
Selection select(const Frame& frame, TetId tet, NodeId node);

/// The same piece of material in a later frame, or in one of a new run of the scene: the element keeps its id, and its
/// corner at the node's place in rest space is the node, or the copy of it that a crack made. Where remeshing took the
/// corner to another element, the node's own first element is taken. Nothing where nobody has been there yet.
Selection follow(const Selection& selection, const Frame& frame);

}  // namespace griffith::ui
