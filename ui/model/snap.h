#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/world/output/frame.h"
#include "ui/model/scene_entry.h"
#include "ui/model/surface_gap.h"
#include "ui/model/view_camera.h"

namespace griffith::ui {

/// Target of snapping.
enum class SnapTarget {
  round_values,  ///< round coordinates, angles and sizes
  surfaces,      ///< the ground and the surfaces of other bodies
};

/// A body that others snap to.
struct SnapBody {
  std::string name;
  PlacedSurface surface;
};

/// Surfaces at the start of a drag, in the placement of the scene.
struct SnapScene {
  PlacedSurface moved;           ///< surface of the moved bodies together; empty if the active entry is no body
  double radius = 0;             ///< radius of a moved projectile, 0 for other points [m]
  std::vector<SnapBody> others;  ///< all other bodies
  std::optional<double> ground;  ///< height [m]
};

/// Returns the surfaces for a drag of the active `entry` together with `moved` ones. `frame`: at the start of the run.
SnapScene snap_scene(const Scene& scene, const Frame& frame, const SceneEntry& entry,
                     const std::vector<SceneEntry>& moved);

/// A contact that a drag snaps to.
struct Snap {
  Vec3 offset = Vec3::Zero();                         ///< displacement from the start of the drag [m]
  std::string onto;                                   ///< name of what is touched
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();  ///< point of the contact [m] and its normal, of length 1
};

/// Returns the displacement that puts what is moved onto the surface that the ray hits first, so that it touches that,
/// sinks into nothing below it along the surface's normal, and moves aside for what stands next to it. `place`: of the
/// entry at the start [m]. Empty if the ray hits nothing.
std::optional<Snap> snap_to_ray(const SnapScene& scene, const Vec3& place, const ViewRay& ray);

/// Returns the displacement changed along one axis, by at most `reach` [m], so that the moved bodies touch another body
/// or the ground; empty if none is so near.
std::optional<Snap> snap_along(const SnapScene& scene, const Vec3& offset, int axis, double reach);

}  // namespace griffith::ui
