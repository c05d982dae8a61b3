#pragma once

#include <optional>
#include <set>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/model/scene_entry.h"
#include "ui/model/view_camera.h"

namespace griffith::ui {

// Regions of nodes, painted on the surface of a body at the start of time. Nodes go by their index in the mesh of the
// body's shape, as NodeListRegion has them.

/// A stroke of the brush.
struct RegionStroke {
  SceneEntry entry;           ///< whose region is painted
  std::int64_t revision = 0;  ///< of the scene, when the stroke began
  bool erases = false;
  std::set<int> nodes;       ///< of the region, if the stroke ended now
  Vec2 last = Vec2::Zero();  ///< where the brush was put down last [pixels]
  bool cancelled = false;    ///< until the button is released
};

/// The nodes of a scene body that lie in the region.
std::set<int> nodes_in_region(const Frame& start, const Scene& scene, int scene_body, const Region& region);

/// Where a ray meets a scene body before it meets any other; nothing where it does not.
std::optional<Vec3> place_on_body(const Frame& start, int scene_body, const ViewRay& ray);

/// The nodes under a brush that is put down at a place of the body: those within `radius` [m] in faces that look
/// against `direction`, or the nearest of these.
std::set<int> nodes_under_brush(const Frame& start, int scene_body, const Vec3& place, const Vec3& direction,
                                double radius);

/// Where nodes of a scene body are [m].
std::vector<Vec3> places_of_nodes(const Frame& start, int scene_body, const std::set<int>& nodes);

}  // namespace griffith::ui
