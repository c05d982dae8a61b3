#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "sim/geometry/half_space.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/splinter_pattern.h"

namespace griffith {

/// Side of a cell, or a part of one, with its neighbor.
struct CellWall {
  HalfSpace inside;
  int neighbor = -1;  ///< another cell; its wall to this one is exactly the opposite half-space
};

/// Material of a splinter, for its color.
enum class SplinterMatter : std::uint8_t { body, mortar };

/// Convex polyhedron, possibly unbounded.
struct ConvexCell {
  std::vector<CellWall> walls;  ///< those of a side with several neighbors are consecutive, with equal half-spaces
  int splinter = 0;             ///< cells of the same number form one splinter
  SplinterMatter matter = SplinterMatter::body;
};

/// Cells that fill the box around a body. Where two meet along a face, each has one wall to the other.
using CellPartition = std::vector<ConvexCell>;

/// Largest number of cells.
inline constexpr double kMaxSplinterCells = 2e6;

/// Returns the cells of a pattern that may meet `bounds` [m]. Relative paths start at `folder`. Throws InputError if a
/// file cannot be read or, naming the place `where`, if there would be more than kMaxSplinterCells cells.
CellPartition make_cells(const SplinterPattern& pattern, const Eigen::AlignedBox3d& bounds,
                         const std::filesystem::path& folder = {}, const std::string& where = "splinters");

// One maker per pattern, called by make_cells().
CellPartition make_voronoi_cells(const VoronoiSplinters& pattern, const Eigen::AlignedBox3d& bounds);
/// Limits the width of rings to `largest` [m]. Rays branch where splinters would become wider.
CellPartition make_radial_cells(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds,
                                double largest = std::numeric_limits<double>::infinity());
CellPartition make_brick_cells(const BrickSplinters& pattern, const Eigen::AlignedBox3d& bounds);
/// Rounds positions to a millionth of the body's size. Throws InputError if the file cannot be read or all of its
/// points lie far from `bounds`.
CellPartition make_point_cells(const PointSplinters& pattern, const Eigen::AlignedBox3d& bounds,
                               const std::filesystem::path& folder);
/// Reads the convex objects of a surface file. Throws InputError, naming the cell, for one that is not convex, not
/// closed, flat or overlapping another.
CellPartition read_cells(const std::filesystem::path& path, double scale);
/// Throws TooManyCells if `cells` are more than kMaxSplinterCells.
void check_cell_count(double cells);
struct TooManyCells {};

/// Returns the Voronoi cells of any points, those that matter within `bounds`. Coincident points count once.
CellPartition voronoi_cells(std::vector<Vec3> points, const Eigen::AlignedBox3d& bounds);

/// Pattern of cells as large as the tets around them.
struct ShardPattern {
  double jitter = 0.6;         ///< 0: each tet's shard grows from its center, 1: from anywhere in it
  int seed = 1;                ///< >= 0; another number gives another pattern
  Vec3 grain = Vec3(0, 1, 0);  ///< direction of elongation; any length but 0
  double elongation = 1;       ///< length over width, >= 1
  bool operator==(const ShardPattern&) const = default;
};

/// Returns the Voronoi cells of one point in each tet of a mesh in rest space.
CellPartition make_shard_cells(const TetMesh& mesh, const ShardPattern& pattern);

/// Returns the cell that contains a point, by a walk from cell `start`.
int locate(const CellPartition& cells, const Vec3& point, int start);

}  // namespace griffith
