#pragma once

#include "app/picture/shown_mesh.h"
#include "renderer/camera.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Returns the corner of a tet nearest to the point where a ray enters it. If the ray misses the tet (its splinters may
/// be drawn elsewhere), the corner nearest to the ray.
NodeId nearest_corner(const ShownMesh& shown, TetId tet, const render::Ray& ray);

/// Returns the point of a tet where a ray enters it, as weights of its corners 1 to 3; its centroid if the ray misses
/// the tet.
Vec3 seen_weights(const ShownMesh& shown, TetId tet, const render::Ray& ray);

/// Returns the distance along a ray at which it enters a tet [m]; infinite if it misses the tet.
double seen_distance(const ShownMesh& shown, TetId tet, const render::Ray& ray);

/// Selects material of the frame, and its body.
void select(ui::EditorState& state, const Frame& frame, const ui::Selection& selection);
/// Selects a node to be explained; does nothing if it does not exist.
void select_node(ui::EditorState& state, const Frame& frame, NodeId node);
/// Selects the node with the highest utilization. If no node carries a load, logs that and selects the node of the last
/// crack, if there is one.
void select_most_loaded(ui::EditorState& state, const Frame& frame);

}  // namespace griffith::app
