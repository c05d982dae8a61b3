#pragma once

#include <Eigen/Geometry>
#include <set>
#include <vector>

#include "app/picture/quantities.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// Indices of the scene's bodies that are not drawn.
using HiddenBodies = std::set<int>;

/// Mesh as shown in a picture, with pieces moved apart and a part cut away: the source of all parts of a picture.
/// Positions of hidden bodies are NaN.
struct ShownMesh {
  const Frame& frame;
  const ViewSettings& view;
  std::vector<Vec3> offsets;    ///< displacement of each body in the picture [m]
  std::vector<Vec3> positions;  ///< drawn positions of nodes [m]
  /// Mean edge of the cubes that six of the tets would fill [m], the scale of element symbols.
  double element_size = 1;
  double sign_size = 1;  ///< scale of symbols at nodes and points [m]: a fraction of the largest body
  NodeId chosen;         ///< node whose forces and plane are shown; invalid: none

  /// True if a point is drawn: on the visible side of the slice plane, and not in a hidden body.
  bool visible(const Vec3& place) const;
  bool is_hidden(BodyId body) const { return !offsets[body].allFinite(); }
  BodyId body_of(NodeId node) const { return frame.elements.bodies[frame.nodes.stars[node].front()]; }
  Vec3 centroid(TetId tet) const;
};

/// Makes the shown mesh. `selection`: determines the chosen node; without one, it is the most loaded node of the
/// visible bodies. The node and the element size are found only if the view has layers. Frame and view must outlive the
/// result.
ShownMesh shown_mesh(const Frame& frame, const ViewSettings& view, const ui::Selection& selection,
                     const HiddenBodies& hidden = {});
ShownMesh shown_mesh(const Frame& frame, ViewSettings&& view, const ui::Selection& selection,
                     const HiddenBodies& hidden = {}) = delete;

/// Converts the view's slice to the type of the renderer.
render::HalfSpace visible_half(const SlicePlane& slice);

/// Returns a light, saturated color for each id; consecutive ids have very different hues.
render::Rgb id_color(std::int32_t id);

}  // namespace griffith::app
