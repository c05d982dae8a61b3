#pragma once

#include <array>
#include <vector>

#include "sim/scene/region.h"

namespace griffith::ui {

/// A line segment in the body's rest space [m].
using RegionLine = std::array<Vec3, 2>;

/// Returns a circle about a center with two perpendicular radii.
std::vector<RegionLine> circle_lines(const Vec3& center, const Vec3& a, const Vec3& b);

/// Returns the edges of a box, three circles of a sphere, or a square of edge `size` [m] with its normal for a
/// half-space; empty for nodes.
std::vector<RegionLine> region_lines(const Region& region, double size);

/// A part of a region that can be dragged along a line: a face of a box, the surface of a sphere, the plane of a
/// half-space.
struct RegionGrip {
  Vec3 place = Vec3::Zero();       ///< position in the body's rest space [m]
  Vec3 direction = Vec3::UnitX();  ///< outward direction of length 1
};
std::vector<RegionGrip> region_grips(const Region& region);

/// Returns the region with the grip moved outward by `distance` [m]. The thickness of a box stays at least 0, the
/// radius of a sphere at least `min_radius` [m], and coordinates within the range of scene files.
Region drag_grip(Region region, std::size_t grip, double distance, double min_radius);

/// Returns the center of a box or sphere, the point of a half-space, and the origin for nodes.
Vec3 region_place(const Region& region);
/// True if the region can be moved, that is, if it is not a list of nodes.
bool has_place(const Region& region);
void move_region(Region& region, const Vec3& offset);
/// Returns the point moved by the offset, rounded to nanometers, within the range of scene files.
Vec3 moved_place(const Vec3& place, const Vec3& offset);

}  // namespace griffith::ui
