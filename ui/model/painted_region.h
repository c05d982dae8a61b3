#pragma once

#include <optional>
#include <set>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "ui/model/scene_entry.h"
#include "ui/model/view_camera.h"

namespace griffith::ui {

// Regions of nodes, painted on the surface of a body at the start of the simulation. Nodes are identified by their
// index in the mesh of the body's shape, as in NodeListRegion.

/// A stroke of the brush.
struct RegionStroke {
  SceneEntry entry;           ///< entry with the painted region
  std::int64_t revision = 0;  ///< revision of the scene at the start of the stroke
  bool erases = false;
  std::set<int> nodes;       ///< nodes of the region with the stroke so far
  Vec2 last = Vec2::Zero();  ///< last position of the brush [pixels]
  bool cancelled = false;    ///< ignored until the button is released
};

/// Returns the nodes of a scene body that lie in the region.
std::set<int> nodes_in_region(const Frame& start, const Scene& scene, int scene_body, const Region& region);

/// Returns the first intersection of a ray with a scene body; empty if there is none or another body is hit first.
std::optional<Vec3> place_on_body(const Frame& start, int scene_body, const ViewRay& ray);

/// Returns the nodes under a brush at a point of the body: those within `radius` [m] on faces that face against
/// `direction`, or the nearest of these.
std::set<int> nodes_under_brush(const Frame& start, int scene_body, const Vec3& place, const Vec3& direction,
                                double radius);

/// Returns the positions of nodes of a scene body [m].
std::vector<Vec3> places_of_nodes(const Frame& start, int scene_body, const std::set<int>& nodes);

}  // namespace griffith::ui
