#pragma once

#include <array>
#include <vector>

#include "sim/scene/region.h"

namespace griffith::ui {

/// A line from one place to another, in the body's rest space [m].
using RegionLine = std::array<Vec3, 2>;

/// The edges of a box, three circles of a sphere, a square of edge `size` [m] with its normal of a half-space; of nodes
/// none.
std::vector<RegionLine> region_lines(const Region& region, double size);

/// A part of a region that is dragged by itself along a line: a face of a box, the surface of a sphere, the
/// plane of a half-space.
struct RegionGrip {
  Vec3 place = Vec3::Zero();       ///< in the body's rest space [m]
  Vec3 direction = Vec3::UnitX();  ///< outwards, of length 1
};
std::vector<RegionGrip> region_grips(const Region& region);

/// The region with that grip so much farther out [m]; a box is left no thinner than nothing, a sphere no smaller than
/// `min_radius` [m], and all of it where scene files can have it.
Region drag_grip(Region region, std::size_t grip, double distance, double min_radius);

/// The middle of a box or sphere, the point of a half-space. Of nodes: their origin.
Vec3 region_place(const Region& region);
/// Whether it can be moved: all but nodes.
bool has_place(const Region& region);
void move_region(Region& region, const Vec3& offset);
/// The place farther along by the offset, to a nanometre, where scene files can have it.
Vec3 moved_place(const Vec3& place, const Vec3& offset);

}  // namespace griffith::ui
