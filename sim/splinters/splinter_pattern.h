#pragma once

#include <filesystem>
#include <variant>

#include "sim/core/linear_algebra.h"

namespace griffith {

// Patterns of splinters: pieces of a body's material that hide the facets of its tets when it breaks (Parker & O'Brien
// 2009, section 5). Lengths are in meters and positions in the body's rest space.

/// Shards around random points: the Voronoi cells of a jittered lattice.
struct VoronoiSplinters {
  double size = 0.1;           ///< distance of the points across the grain, > 0
  double jitter = 1;           ///< 0: the regular lattice, 1: anywhere within its cells
  int seed = 1;                ///< >= 0; another number gives another pattern
  Vec3 grain = Vec3(0, 1, 0);  ///< direction of elongation; any length but 0
  double elongation = 1;       ///< length over width, >= 1
  bool operator==(const VoronoiSplinters&) const = default;
};

/// Sectors and rings around an axis, as in glass around the point of an impact. The rings' borders are chords.
struct RadialSplinters {
  Vec3 center = Vec3::Zero();  ///< point of the axis
  Vec3 axis = Vec3(0, 0, 1);   ///< any length but 0
  int sectors = 16;            ///< 4..1000
  double first_ring = 0.05;    ///< radius of the innermost ring, > 0
  double growth = 1.5;         ///< width of each ring over that of the next inner one, 1..10
  double jitter = 0.5;         ///< 0: regular, 1: as irregular as possible
  int seed = 1;                ///< >= 0
  bool operator==(const RadialSplinters&) const = default;
};

/// Bricks in running bond, courses along x stacked along y. Each course is shifted by half a brick.
struct BrickSplinters {
  Vec3 size = Vec3(0.24, 0.07, 0.115);  ///< size of a brick without mortar along x, y, z, > 0
  double mortar = 0.01;        ///< width of the joints, each of which breaks along with the brick above or right; >= 0
  Vec3 origin = Vec3::Zero();  ///< corner of a brick
  bool operator==(const BrickSplinters&) const = default;
};

/// Voronoi cells of points from a file.
struct PointSplinters {
  std::filesystem::path path;  ///< text with x, y, z on each line; a heading line is skipped
  double scale = 1;            ///< meters per unit of the file, > 0
  bool operator==(const PointSplinters&) const = default;
};

/// Convex cells from a file, exported by a prefracture tool.
struct CellSplinters {
  std::filesystem::path path;  ///< any surface format; each object is a cell
  double scale = 1;            ///< meters per unit of the file, > 0
  bool operator==(const CellSplinters&) const = default;
};

using SplinterPattern = std::variant<VoronoiSplinters, RadialSplinters, BrickSplinters, PointSplinters, CellSplinters>;

}  // namespace griffith
