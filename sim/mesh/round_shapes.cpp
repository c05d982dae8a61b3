#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/core/error.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/hex_mesh.h"
#include "sim/mesh/shapes.h"

namespace griffith {
namespace {

// The corners of the core lie at this fraction of the radius, and its sides bulge halfway to a circle, for cells of
// even shape.
constexpr double kCoreRadius = 0.6;
constexpr double kCoreBulge = 0.5;

/// Returns the point of the unit circle (z = 0) or sphere over the point `q` ≠ 0 of the square or cube. Equal steps on
/// a side give equal angles (Ronchi, Iacono and Paolucci 1996, the equiangular cubed sphere).
Vec3 radial_direction(const Vec3& q) {
  const Vec3 angles = std::numbers::pi / 4 * q / q.cwiseAbs().maxCoeff();
  return angles.array().tan().matrix().normalized();
}

/// Returns the image in a unit ball of dimension `dimensions` of core point q (in [−1, 1]³), moved outward by
/// `outwards` in 0..1.
Vec3 ball_point(const Vec3& q, double outwards, int dimensions) {
  if (q.isZero()) return q;
  const Vec3 direction = radial_direction(q);
  const Vec3 bulged = q.cwiseAbs().maxCoeff() * direction;
  const Vec3 core = kCoreRadius * ((1 - kCoreBulge) / std::sqrt(dimensions) * q + kCoreBulge * bulged);
  return (1 - outwards) * core + outwards * direction;
}

struct BallCells {
  int core, shells;
};

BallCells ball_cells(double radius, double element_size, int dimensions, const char* what) {
  const BallCells cells = {std::max(2, cell_count(1.2 * radius, element_size, what)),
                           cell_count(0.45 * radius, element_size, what)};
  const double total = std::pow(cells.core, dimensions - 1) * (cells.core + 2.0 * dimensions * cells.shells);
  if (total > kMaxCells) throw InputError(what, "the element size requires too many cells", "make the elements larger");
  return cells;
}

/// Node of a planar mesh: lattice point and layer, its key in a HexMeshBuilder.
struct PlanarNode {
  int i, j, layer;
};
/// Cell whose corner c has the local coordinates (c & 1, c >> 1).
using PlanarCell = std::array<PlanarNode, 4>;

/// Returns the lattice points around a rectangle of nx × ny cells, in order.
std::vector<PlanarNode> perimeter(int nx, int ny) {
  std::vector<PlanarNode> loop;
  for (int i = 0; i < nx; ++i) loop.push_back({i, 0, 0});
  for (int j = 0; j < ny; ++j) loop.push_back({nx, j, 0});
  for (int i = nx; i > 0; --i) loop.push_back({i, ny, 0});
  for (int j = ny; j > 0; --j) loop.push_back({0, j, 0});
  return loop;
}

void add_lattice(std::vector<PlanarCell>& cells, int first_i, int last_i, int first_j, int last_j) {
  for (int j = first_j; j < last_j; ++j)
    for (int i = first_i; i < last_i; ++i)
      cells.push_back({{{i, j, 0}, {i + 1, j, 0}, {i, j + 1, 0}, {i + 1, j + 1, 0}}});
}

/// Adds `layers` rings of cells on a closed loop.
void add_rings(std::vector<PlanarCell>& cells, const std::vector<PlanarNode>& loop, int layers) {
  for (std::size_t s = 0; s < loop.size(); ++s) {
    const PlanarNode a = loop[s], b = loop[(s + 1) % loop.size()];
    for (int layer = 0; layer < layers; ++layer)
      cells.push_back({{{a.i, a.j, layer}, {b.i, b.j, layer}, {a.i, a.j, layer + 1}, {b.i, b.j, layer + 1}}});
  }
}

/// Sweeps planar cells along z, from −length/2 to length/2.
HexMesh sweep(const std::vector<PlanarCell>& cells, const std::function<Vec2(const PlanarNode&)>& position,
              double length, int levels) {
  if (double(cells.size()) * levels > kMaxCells)
    throw InputError("swept shape", "the element size requires too many cells", "make the elements larger");
  HexMeshBuilder builder;
  for (int level = 0; level < levels; ++level)
    for (const PlanarCell& cell : cells) {
      std::array<int, 8> corners;
      for (int c = 0; c < 8; ++c) {
        const PlanarNode& node = cell[c & 3];
        const int k = level + (c >> 2);
        const Vec2 planar = position(node);
        corners[c] = builder.node({k, node.layer, node.j, node.i},
                                  Vec3(planar.x(), planar.y(), length * (2 * k - levels) / (2.0 * levels)));
      }
      builder.add_cell(corners);
    }
  return builder.take();
}

/// Adds the cells over one face of the core. `corner(a, b)`: lattice point of the core.
void add_shells(HexMeshBuilder& builder, const BallCells& cells, double radius,
                const std::function<std::array<int, 3>(int a, int b)>& corner) {
  for (int layer = 0; layer < cells.shells; ++layer)
    for (int b = 0; b < cells.core; ++b)
      for (int a = 0; a < cells.core; ++a) {
        std::array<int, 8> corners;
        for (int c = 0; c < 8; ++c) {
          const auto [i, j, k] = corner(a + (c & 1), b + (c >> 1 & 1));
          const Vec3 q = Vec3(2 * i - cells.core, 2 * j - cells.core, 2 * k - cells.core) / cells.core;
          const int shell = layer + (c >> 2);
          corners[c] = builder.node({k, j, i, shell}, radius * ball_point(q, double(shell) / cells.shells, 3));
        }
        builder.add_cell(corners);
      }
}

void add_core(HexMeshBuilder& builder, int core, double radius) {
  const HexMesh cube = make_box_hexes(Vec3::Constant(2), {core, core, core});
  for (const auto& cell : cube.cells) {
    std::array<int, 8> corners;
    for (int c = 0; c < 8; ++c) {
      const int node = cell[c], side = core + 1;
      corners[c] = builder.node({node / (side * side), node / side % side, node % side, 0},
                                radius * ball_point(cube.points[node], 0, 3));
    }
    builder.add_cell(corners);
  }
}

/// Plate with a hole: rings of cells from the hole to the edge of the middle part, lattices beyond it at two ends.
struct PlateLayout {
  Vec2 middle;                      ///< edge lengths of the middle part, in rings
  Vec2 beyond;                      ///< length of a lattice at either end, along x and y [m]
  std::array<int, 2> cells;         ///< numbers of cells on the sides of the middle part
  std::array<int, 2> cells_beyond;  ///< numbers of cells of a lattice, along x and y; 0: no lattice
  double hole_radius;
  double growth;  ///< logarithm of the ratio of the radii at the edge and the hole
  int rings;
};

PlateLayout lay_out_plate(const Vec2& size, double hole_radius, double element_size) {
  const double side = size.minCoeff();
  if (!(hole_radius > 0 && hole_radius < 0.5 * side))
    throw InputError("plate with hole", "hole radius " + std::to_string(hole_radius) + " m",
                     "more than 0 and less than half the smaller side");
  PlateLayout plate{.middle = size,
                    .beyond = (size - Vec2::Constant(side)) / 2,
                    .cells = {},
                    .cells_beyond = {0, 0},
                    .hole_radius = hole_radius,
                    .growth = std::log(0.5 * side / hole_radius),
                    .rings = 1};
  for (int axis : {0, 1}) {
    // Rings reach to the edge if less than half a cell is left beyond the middle square.
    if (plate.beyond[axis] >= element_size / 2) {
      plate.cells_beyond[axis] = cell_count(plate.beyond[axis], element_size, "plate");
      plate.middle[axis] = side;
    }
    plate.cells[axis] = cell_count(plate.middle[axis], element_size, "plate");
  }
  // Number of rings that makes cells about square when they grow with their distance from the hole.
  const double rings = 2 / std::numbers::pi * std::max(plate.cells[0], plate.cells[1]) * plate.growth;
  plate.rings = static_cast<int>(std::clamp(std::round(rings), 1.0, double(kMaxCells)));
  return plate;
}

/// Layer 0 is the edge of the middle part and all beyond it, layer `rings` the wall of the hole.
Vec2 plate_point(const PlateLayout& plate, const PlanarNode& node) {
  const std::array<int, 2> lattice = {node.i, node.j};
  Vec2 outer, q;
  for (int axis : {0, 1}) {
    const int cells = plate.cells[axis], inside = std::clamp(lattice[axis], 0, cells), outside = lattice[axis] - inside;
    q[axis] = (2.0 * inside - cells) / cells;
    outer[axis] = plate.middle[axis] / 2 * q[axis];
    if (outside != 0) outer[axis] += plate.beyond[axis] / plate.cells_beyond[axis] * outside;
  }
  if (node.layer == 0) return outer;
  const Vec2 inner = plate.hole_radius * radial_direction({q.x(), q.y(), 0}).head<2>();
  const double outwards =
      std::expm1(plate.growth * (plate.rings - node.layer) / plate.rings) / std::expm1(plate.growth);
  return inner + outwards * (outer - inner);
}

}  // namespace

TetSoup make_cylinder(double radius, double length, const Vec2& element_size, BoxPattern pattern) {
  const auto [core, shells] = ball_cells(radius, element_size.x(), 2, "cylinder, radius");
  const int levels = cell_count(length, element_size.y(), "cylinder, length");
  std::vector<PlanarCell> cells;
  add_lattice(cells, 0, core, 0, core);
  add_rings(cells, perimeter(core, core), shells);
  const auto position = [&](const PlanarNode& node) -> Vec2 {
    const Vec3 q = Vec3(2 * node.i - core, 2 * node.j - core, 0) / core;
    return radius * ball_point(q, double(node.layer) / shells, 2).head<2>();
  };
  return cut_into_tets(sweep(cells, position, length, levels), pattern);
}

TetSoup make_sphere(double radius, double element_size, BoxPattern pattern) {
  const BallCells cells = ball_cells(radius, element_size, 3, "sphere, radius");
  HexMeshBuilder builder;
  add_core(builder, cells.core, radius);
  for (int end : {0, cells.core}) {
    add_shells(builder, cells, radius, [=](int a, int b) { return std::array{end, a, b}; });
    add_shells(builder, cells, radius, [=](int a, int b) { return std::array{a, end, b}; });
    add_shells(builder, cells, radius, [=](int a, int b) { return std::array{a, b, end}; });
  }
  return cut_into_tets(builder.take(), pattern);
}

TetSoup make_plate_with_hole(const Vec3& size, double hole_radius, const Vec2& element_size, BoxPattern pattern) {
  const int levels = cell_count(size.z(), element_size.y(), "plate, thickness");
  const PlateLayout plate = lay_out_plate(size.head<2>(), hole_radius, element_size.x());
  const auto [nx, ny] = plate.cells;
  const auto [beyond_x, beyond_y] = plate.cells_beyond;
  if (double(plate.rings) * (nx + ny) * 2 * levels > kMaxCells)
    throw InputError("plate with hole", "the element size requires too many cells", "make the elements larger");
  std::vector<PlanarCell> cells;
  add_rings(cells, perimeter(nx, ny), plate.rings);
  add_lattice(cells, -beyond_x, 0, 0, ny);
  add_lattice(cells, nx, nx + beyond_x, 0, ny);
  add_lattice(cells, 0, nx, -beyond_y, 0);
  add_lattice(cells, 0, nx, ny, ny + beyond_y);
  const auto position = [&](const PlanarNode& node) { return plate_point(plate, node); };
  return cut_into_tets(sweep(cells, position, size.z(), levels), pattern);
}

}  // namespace griffith
