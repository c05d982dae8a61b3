#pragma once

#include <filesystem>
#include <variant>

#include "sim/core/linear_algebra.h"

namespace griffith {

// How a body is parted into splinters: the pieces of its material that hide the facets of its tets when it breaks
// (Parker & O'Brien 2009, section 5). Lengths are in metres and places in the body's rest space.

/// Shards round random points: the Voronoi cells of a jittered lattice.
struct VoronoiSplinters {
  double size = 0.1;           ///< distance of the points across the grain, > 0
  double jitter = 1;           ///< 0: the lattice itself, 1: anywhere within its cells
  int seed = 1;                ///< >= 0; another number, another pattern
  Vec3 grain = Vec3(0, 1, 0);  ///< direction along which splinters are long; any length but 0
  double elongation = 1;       ///< how many times longer than across, >= 1
  bool operator==(const VoronoiSplinters&) const = default;
};

/// Sectors and rings round an axis, as in glass round the point of an impact. The rings' borders are chords.
struct RadialSplinters {
  Vec3 center = Vec3::Zero();  ///< a point of the axis
  Vec3 axis = Vec3(0, 0, 1);   ///< any length but 0
  int sectors = 16;            ///< 4..1000
  double first_ring = 0.05;    ///< radius of the innermost ring, > 0
  double growth = 1.5;         ///< how many times wider each ring is than the one inside it, 1..10
  double jitter = 0.5;         ///< 0: regular, 1: as irregular as it may be
  int seed = 1;                ///< >= 0
  bool operator==(const RadialSplinters&) const = default;
};

/// Bricks in running bond, courses along x stacked along y: each course is shifted by half a brick.
struct BrickSplinters {
  Vec3 size = Vec3(0.24, 0.07, 0.115);  ///< of a brick without mortar along x, y, z, > 0
  double mortar = 0.01;                 ///< width of the joints, which break along with the brick above or right; >= 0
  Vec3 origin = Vec3::Zero();           ///< a corner of a brick
  bool operator==(const BrickSplinters&) const = default;
};

/// Voronoi cells of points from a file.
struct PointSplinters {
  std::filesystem::path path;  ///< text, x, y, z a line; a heading line is passed over
  double scale = 1;            ///< metres per unit of the file, > 0
  bool operator==(const PointSplinters&) const = default;
};

/// Convex cells from a file, as programs that break things ahead of time export them.
struct CellSplinters {
  std::filesystem::path path;  ///< any surface format: each object is a cell
  double scale = 1;            ///< metres per unit of the file, > 0
  bool operator==(const CellSplinters&) const = default;
};

using SplinterPattern = std::variant<VoronoiSplinters, RadialSplinters, BrickSplinters, PointSplinters, CellSplinters>;

}  // namespace griffith
