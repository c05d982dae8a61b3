#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "sim/core/error.h"
#include "sim/geometry/disjoint_sets.h"
#include "sim/splinters/convex_cells.h"
#include "sim/splinters/object_cell.h"

namespace griffith {
namespace {

/// Possible error of positions relative to the largest coordinate, since readers use single precision.
constexpr double kRounding = 1e-6;

/// Two coincident sides of different cells.
struct SharedSide {
  int a = 0, plane_a = 0, b = 0, plane_b = 0;
};

std::vector<Vec3> outline(const ConvexPolyhedron& polyhedron, const PolyhedronFace& face) {
  std::vector<Vec3> corners;
  for (const int corner : face.corners) corners.push_back(polyhedron.corners[corner]);
  return corners;
}

/// Assembly of the cells of a file: finds their contacts, and gives touching sides one plane.
class Assembly {
 public:
  Assembly(std::vector<ObjectCell> cells, double tolerance, std::string file)
      : cells_(std::move(cells)), tolerance_(tolerance), file_(std::move(file)) {}

  CellPartition run() {
    find_shared_sides();
    unite_planes();
    return partition();
  }

 private:
  void find_shared_sides();
  void compare(int a, int b);
  bool share_a_side(int a, int b);
  void unite_planes();
  int slot(int cell, int plane) const { return first_slot_[cell] + plane; }
  void fit_planes(std::span<const std::pair<int, int>> sides);
  CellPartition partition() const;

  std::vector<ObjectCell> cells_;
  double tolerance_;
  std::string file_;
  std::vector<SharedSide> shared_;
  std::vector<int> first_slot_;
};

/// Sweeps along x over the boxes.
void Assembly::find_shared_sides() {
  std::vector<int> order(cells_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return cells_[i].box.min().x(); });
  const Vec3 margin = Vec3::Constant(2 * tolerance_);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::AlignedBox3d& box = cells_[order[i]].box;
    const Eigen::AlignedBox3d near(Vec3(box.min() - margin), Vec3(box.max() + margin));
    for (std::size_t j = i + 1; j < order.size() && cells_[order[j]].box.min().x() <= near.max().x(); ++j)
      if (near.intersects(cells_[order[j]].box)) compare(std::min(order[i], order[j]), std::max(order[i], order[j]));
  }
}

void Assembly::compare(int a, int b) {
  if (share_a_side(a, b)) return;
  const ConvexPolyhedron common = common_part(cells_[a], cells_[b], 4 * tolerance_);
  const double minimum = std::pow(4 * tolerance_, 3);
  if (common.empty() || volume(common) <= minimum) return;
  char text[64];
  std::snprintf(text, sizeof text, "\" by %.3g m3", volume(common));
  throw InputError(file_ + ", cell \"" + cells_[a].name + "\"", "overlaps the cell \"" + cells_[b].name + text,
                   "cells have to meet face to face, without a gap or a common part");
}

bool Assembly::share_a_side(int a, int b) {
  constexpr double kOpposite = -0.999;
  bool any = false;
  for (const PolyhedronFace& face_a : cells_[a].polyhedron.faces) {
    const HalfSpace& plane_a = cells_[a].planes[face_a.wall];
    for (const PolyhedronFace& face_b : cells_[b].polyhedron.faces) {
      if (plane_a.normal.dot(cells_[b].planes[face_b.wall].normal) > kOpposite) continue;
      std::vector<Vec3> patch = outline(cells_[b].polyhedron, face_b);
      const auto off = [&](const Vec3& corner) { return std::abs(plane_a.distance(corner)) > 4 * tolerance_; };
      if (std::ranges::any_of(patch, off)) continue;
      for (std::size_t i = 0; i < cells_[a].planes.size() && !patch.empty(); ++i)
        if (static_cast<int>(i) != face_a.wall) patch = clipped(patch, cells_[a].planes[i]);
      if (area_vector(patch).norm() <= tolerance_ * cells_[a].box.diagonal().norm()) continue;
      shared_.push_back({a, face_a.wall, b, face_b.wall});
      any = true;
    }
  }
  return any;
}

/// Gives coincident sides the plane that fits all their corners best, so that they leave no gap.
void Assembly::unite_planes() {
  std::vector<std::pair<int, int>> sides;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    first_slot_.push_back(static_cast<int>(sides.size()));
    for (std::size_t plane = 0; plane < cells_[cell].planes.size(); ++plane)
      sides.emplace_back(static_cast<int>(cell), static_cast<int>(plane));
  }
  DisjointSets sets(static_cast<int>(sides.size()));
  for (const SharedSide& side : shared_) sets.join(slot(side.a, side.plane_a), slot(side.b, side.plane_b));
  const auto group_of = [&](const auto& side) { return sets.find(slot(side.first, side.second)); };
  std::ranges::stable_sort(sides, {}, group_of);
  for (std::size_t i = 0; i < sides.size();) {
    const int group = group_of(sides[i]);
    std::size_t end = i;
    while (end < sides.size() && group_of(sides[end]) == group) ++end;
    fit_planes(std::span(sides).subspan(i, end - i));
    i = end;
  }
}

void Assembly::fit_planes(std::span<const std::pair<int, int>> sides) {
  if (sides.size() < 2) return;
  std::vector<Vec3> corners;
  for (const auto& [cell, plane] : sides)
    for (const PolyhedronFace& face : cells_[cell].polyhedron.faces)
      if (face.wall == plane) std::ranges::copy(outline(cells_[cell].polyhedron, face), std::back_inserter(corners));
  Vec3 mean = Vec3::Zero();
  for (const Vec3& corner : corners) mean += corner / static_cast<double>(corners.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& corner : corners) spread += (corner - mean) * (corner - mean).transpose();
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(0).normalized();
  const HalfSpace common{normal, normal.dot(mean)};
  for (const auto& [cell, plane] : sides) {
    HalfSpace& own = cells_[cell].planes[plane];
    own = own.normal.dot(normal) > 0 ? common : common.opposite();
  }
}

/// Returns cells with a wall for each neighbor of a side, consecutive for one side; one without neighbor for an outer
/// side.
CellPartition Assembly::partition() const {
  std::vector<std::vector<std::pair<int, int>>> neighbors(cells_.size());  // plane, cell
  for (const SharedSide& side : shared_) {
    neighbors[side.a].emplace_back(side.plane_a, side.b);
    neighbors[side.b].emplace_back(side.plane_b, side.a);
  }
  CellPartition partition(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::ranges::sort(neighbors[i]);
    partition[i].splinter = static_cast<int>(i);
    for (int plane = 0; plane < std::ssize(cells_[i].planes); ++plane) {
      const std::size_t before = partition[i].walls.size();
      for (const auto& [at, cell] : neighbors[i])
        if (at == plane) partition[i].walls.push_back({cells_[i].planes[plane], cell});
      if (partition[i].walls.size() == before) partition[i].walls.push_back({cells_[i].planes[plane], -1});
    }
  }
  return partition;
}

}  // namespace

CellPartition read_cells(const std::filesystem::path& path, double scale) {
  std::vector<SurfaceObject> objects = read_surface_objects(path);
  std::erase_if(objects, [](const SurfaceObject& object) { return object.surface.triangles.empty(); });
  if (objects.empty()) throw InputError(path.string(), "holds no cells", "export each cell as an object of its own");
  check_cell_count(static_cast<double>(objects.size()));
  double largest = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].name.empty()) objects[i].name = std::to_string(i + 1);
    for (Vec3& point : objects[i].surface.points) {
      if (!(point *= scale).allFinite())
        throw InputError(path.string() + ", cell \"" + objects[i].name + "\"", "has a coordinate that is not finite",
                         "export the cells again");
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
  }
  const double tolerance = kRounding * largest;
  std::vector<ObjectCell> cells;
  for (const SurfaceObject& object : objects) cells.push_back(object_cell(object, tolerance, path.string()));
  return Assembly(std::move(cells), tolerance, path.string()).run();
}

}  // namespace griffith
