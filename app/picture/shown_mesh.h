#pragma once

#include <Eigen/Geometry>
#include <set>
#include <vector>

#include "app/picture/quantities.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// Bodies of the scene that are not drawn, by their index.
using HiddenBodies = std::set<int>;

/// The mesh as a picture shows it: pieces moved apart, part of it cut away. What all parts of a picture are made from.
/// Where hidden bodies are drawn is not a number.
struct ShownMesh {
  const Frame& frame;
  const ViewSettings& view;
  std::vector<Vec3> offsets;    ///< per body: how far it is drawn from where it is [m]
  std::vector<Vec3> positions;  ///< per node, as drawn [m]
  /// Edge of the cubes that six of the tets would fill, mean [m]: what signs of elements go by.
  double element_size = 1;
  double sign_size = 1;  ///< what signs at nodes and places go by [m]: a share of the largest body
  NodeId chosen;         ///< whose forces and plane are shown; invalid where there is none

  /// Whether a place is drawn: on that side of the slice plane, and of no hidden body.
  bool visible(const Vec3& place) const;
  bool is_hidden(BodyId body) const { return !offsets[body].allFinite(); }
  BodyId body_of(NodeId node) const { return frame.elements.bodies[frame.nodes.stars[node].front()]; }
  Vec3 centroid(TetId tet) const;
};

/// `selection`: of a node; without one, the most loaded node is the chosen one; nodes of hidden bodies are
/// not. Where the view has no layers, there is
/// no need to know of it, nor of the size of elements. Frame and view must outlive what is made of them.
ShownMesh shown_mesh(const Frame& frame, const ViewSettings& view, const ui::Selection& selection,
                     const HiddenBodies& hidden = {});
ShownMesh shown_mesh(const Frame& frame, ViewSettings&& view, const ui::Selection& selection,
                     const HiddenBodies& hidden = {}) = delete;

/// The view's slice as the renderer wants it.
render::HalfSpace visible_half(const SlicePlane& slice);

/// A light, saturated colour of its own for each id; neighbours in number are far apart in hue.
render::Rgb id_color(std::int32_t id);

}  // namespace griffith::app
