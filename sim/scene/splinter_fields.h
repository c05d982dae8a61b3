#pragma once

#include "sim/scene/field.h"
#include "sim/splinters/splinter_pattern.h"

// Fields of splinter patterns, a part of the table in scene_fields.h.

namespace griffith {

inline constexpr Numbers kSplinterLength = between(1e-5, 1e5, "m");
inline constexpr Numbers kSeed = between(0, 2147483647);
inline constexpr Numbers kJitter = between(0, 1, "-");

template <class Archive>
void describe(Archive& archive, VoronoiSplinters& shards) {
  archive.field("size", shards.size, kSplinterLength, "Size of a splinter across the grain");
  archive.field("jitter", shards.jitter, kJitter, "Irregularity: 0 makes cubes, 1 random shards");
  archive.field("seed", shards.seed, kSeed, "Seed of the random numbers");
  archive.field("grain", shards.grain, kDirection, "Direction of elongation; any length but 0");
  archive.field("elongation", shards.elongation, between(1, 1000, "-"), "Length over width");
}

template <class Archive>
void describe(Archive& archive, RadialSplinters& rings) {
  archive.field("center", rings.center, kPlace, "Point of the axis");
  archive.field("axis", rings.axis, kDirection, "Direction of the axis; any length but 0");
  archive.field("sectors", rings.sectors, between(4, 1000), "Splinters in a ring");
  archive.field("first_ring", rings.first_ring, kSplinterLength, "Radius of the innermost ring");
  archive.field("growth", rings.growth, between(1, 10, "-"), "Width of each ring over that of the next inner one");
  archive.field("jitter", rings.jitter, kJitter, "Irregularity: 0 makes regular sectors and rings");
  archive.field("seed", rings.seed, kSeed, "Seed of the random numbers");
}

template <class Archive>
void describe(Archive& archive, BrickSplinters& bricks) {
  archive.field("size", bricks.size, kSplinterLength, "Edge lengths of a brick along x, y, z, without mortar");
  archive.field("mortar", bricks.mortar, between(0, 1e5, "m"), "Width of the joints; each breaks along with a brick");
  archive.field("origin", bricks.origin, kPlace, "Lower corner of a brick");
  archive.require(bricks.mortar < bricks.size.minCoeff(), "mortar", "is as wide as a brick",
                  "use less than the brick's smallest edge");
}

template <class Archive>
void describe(Archive& archive, PointSplinters& points) {
  archive.field("path", points.path, MeshPath{"list of points"},
                "Text file with x, y, z on each line; relative to the scene file's folder");
  archive.field("scale", points.scale, between(1e-9, 1e6), "Meters per unit of the file");
}

template <class Archive>
void describe(Archive& archive, CellSplinters& cells) {
  archive.field(
      "path", cells.path, MeshPath{"file of cells"},
      "Surface file (.obj, .ply, .gltf, ...), each object a convex cell; relative to the scene file's folder");
  archive.field("scale", cells.scale, between(1e-9, 1e6), "Meters per unit of the file");
}

template <class Archive>
void describe(Archive& archive, SplinterPattern& pattern) {
  archive.template alternative<VoronoiSplinters>("voronoi", pattern, Parts{},
                                                 "Shards around random points; long ones resemble wood");
  archive.template alternative<RadialSplinters>("radial", pattern, Parts{},
                                                "Sectors and rings around an axis, as in glass after an impact");
  archive.template alternative<BrickSplinters>("bricks", pattern, Parts{},
                                               "Bricks in running bond: courses along x, stacked along y");
  archive.template alternative<PointSplinters>("points", pattern, Parts{}, "Shards around points from a file");
  archive.template alternative<CellSplinters>("cells", pattern, Parts{}, "Convex cells from a file");
}

}  // namespace griffith
