#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/splinters/convex_cells.h"
#include "sim/splinters/random_unit.h"

namespace griffith {
namespace {

/// Rays from the axis and rings round it; the node of a ring on a ray has a radius of its own.
class RadialPattern {
 public:
  RadialPattern(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds)
      : pattern_(pattern), across_(pattern.axis.normalized().unitOrthogonal()) {
    up_ = pattern.axis.normalized().cross(across_);
    const double reach = (bounds.center() - pattern.center).norm() + bounds.diagonal().norm() / 2;
    double width = pattern.first_ring, radius = 0;
    while (radius < reach) {
      check_cell_count((std::ssize(radii_) + 2.0) * pattern.sectors);
      radii_.push_back(radius += width);
      widths_.push_back(width);
      width *= pattern.growth;
    }
  }

  CellPartition cells() const {
    CellPartition cells;
    for (int ring = 0; ring <= rings(); ++ring)
      for (int sector = 0; sector < pattern_.sectors; ++sector) cells.push_back(cell(ring, sector));
    return cells;
  }

 private:
  int rings() const { return static_cast<int>(radii_.size()); }
  int wrapped(int sector) const { return (sector + pattern_.sectors) % pattern_.sectors; }
  int index(int ring, int sector) const { return ring * pattern_.sectors + wrapped(sector); }

  double angle(int ray) const {
    // Two rays never come closer than a fifth of their mean distance.
    const double shift = 0.8 * pattern_.jitter * (random_unit(pattern_.seed, wrapped(ray), -1) - 0.5);
    return 2 * std::numbers::pi * (wrapped(ray) + shift) / pattern_.sectors;
  }
  Vec3 direction(int ray) const { return std::cos(angle(ray)) * across_ + std::sin(angle(ray)) * up_; }

  Vec3 node(int ring, int ray) const {
    const double shift = 0.8 * pattern_.jitter * (random_unit(pattern_.seed, wrapped(ray), ring) - 0.5);
    return pattern_.center + (radii_[ring] + shift * widths_[ring]) * direction(ray);
  }

  /// Everything behind a ray, seen the way angles grow.
  HalfSpace behind_ray(int ray) const {
    const Vec3 normal = pattern_.axis.normalized().cross(direction(ray)).normalized();
    return {normal, normal.dot(pattern_.center)};
  }

  HalfSpace within_ring(int ring, int sector) const {
    const Vec3 begin = node(ring, sector), end = node(ring, sector + 1);
    const Vec3 normal = (end - begin).cross(pattern_.axis).normalized();
    return {normal, normal.dot((begin + end) / 2)};
  }

  ConvexCell cell(int ring, int sector) const {
    ConvexCell cell;
    cell.splinter = index(ring, sector);
    cell.walls.push_back({behind_ray(sector).opposite(), index(ring, sector - 1)});
    cell.walls.push_back({behind_ray(wrapped(sector + 1)), index(ring, sector + 1)});
    if (ring > 0) cell.walls.push_back({within_ring(ring - 1, sector).opposite(), index(ring - 1, sector)});
    if (ring < rings()) cell.walls.push_back({within_ring(ring, sector), index(ring + 1, sector)});
    return cell;
  }

  const RadialSplinters& pattern_;
  Vec3 across_, up_;
  std::vector<double> radii_, widths_;
};

}  // namespace

CellPartition make_radial_cells(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds) {
  return RadialPattern(pattern, bounds).cells();
}

}  // namespace griffith
