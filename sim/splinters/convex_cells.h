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

/// A side of a cell, or a part of one, and what lies beyond.
struct CellWall {
  HalfSpace inside;
  int neighbour = -1;  ///< another cell; its wall to this one is exactly the opposite half-space
};

/// What a splinter is made of, for its colour.
enum class SplinterMatter : std::uint8_t { body, mortar };

/// A convex polyhedron, possibly unbounded.
struct ConvexCell {
  std::vector<CellWall> walls;  ///< those of a side with several neighbours one after the other, of equal half-spaces
  int splinter = 0;             ///< cells of the same number belong together
  SplinterMatter matter = SplinterMatter::body;
};

/// Cells that fill the box round a body: where two meet along a face, each has one wall to the other.
using CellPartition = std::vector<ConvexCell>;

/// More cells than this are refused.
inline constexpr double kMaxSplinterCells = 2e6;

/// The cells of a pattern that may meet `bounds` [m]. Relative paths start at `folder`. Throws InputError when a file
/// cannot be read or, naming the place `where`, when there would be more than kMaxSplinterCells cells.
CellPartition make_cells(const SplinterPattern& pattern, const Eigen::AlignedBox3d& bounds,
                         const std::filesystem::path& folder = {}, const std::string& where = "splinters");

// One maker a pattern, behind make_cells().
CellPartition make_voronoi_cells(const VoronoiSplinters& pattern, const Eigen::AlignedBox3d& bounds);
/// Rings do not become wider than `largest` [m], and rays branch where splinters would.
CellPartition make_radial_cells(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds,
                                double largest = std::numeric_limits<double>::infinity());
CellPartition make_brick_cells(const BrickSplinters& pattern, const Eigen::AlignedBox3d& bounds);
/// Places are rounded to a millionth of the body's size. Throws InputError when the file cannot be read or all of its
/// points lie far from `bounds`.
CellPartition make_point_cells(const PointSplinters& pattern, const Eigen::AlignedBox3d& bounds,
                               const std::filesystem::path& folder);
/// The convex objects of a surface file. Throws InputError, naming the cell, for one that is not convex, not closed,
/// flat or overlaps another.
CellPartition read_cells(const std::filesystem::path& path, double scale);
/// Throws TooManyCells when `cells` are more than kMaxSplinterCells.
void check_cell_count(double cells);
struct TooManyCells {};

/// The Voronoi cells of any different points, those that matter within `bounds`; coincident points count once.
CellPartition voronoi_cells(std::vector<Vec3> points, const Eigen::AlignedBox3d& bounds);

/// Cells of the size of tets, whatever that is: how shards lie round them.
struct ShardPattern {
  double jitter = 0.6;         ///< 0: each tet's shard grows from its middle, 1: from anywhere in it
  int seed = 1;                ///< >= 0; another number, another pattern
  Vec3 grain = Vec3(0, 1, 0);  ///< direction along which they are long; any length but 0
  double elongation = 1;       ///< how many times longer than across, >= 1
};

/// The Voronoi cells of a point in each tet of a mesh in rest space.
CellPartition make_shard_cells(const TetMesh& mesh, const ShardPattern& pattern);

/// The cell that holds a point, from a walk that starts at cell `start`.
int locate(const CellPartition& cells, const Vec3& point, int start);

}  // namespace griffith
