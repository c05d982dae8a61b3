#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/splinters/convex_cells.h"
#include "sim/splinters/random_unit.h"

namespace griffith {
namespace {

/// Rays from the axis and rings around it. The node of a ring on a ray has its own radius. Rays of level k + 1 are
/// those of level k and one between each two.
class RadialPattern {
 public:
  RadialPattern(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds, double largest)
      : pattern_(pattern), across_(pattern.axis.normalized().unitOrthogonal()) {
    up_ = pattern.axis.normalized().cross(across_);
    const double reach = (bounds.center() - pattern.center).norm() + bounds.diagonal().norm() / 2;
    double width = pattern.first_ring, radius = 0;
    int level = 0;
    while (radius < reach) {
      radius += width;
      while (2 * std::numbers::pi * radius / sectors(level) > 1.5 * largest) check_cell_count(sectors(++level));
      add_ring(radius, width, level);
      width = std::max(width, std::min(width * pattern.growth, largest));
    }
    add_ring(radius, width, level);  // all beyond
  }

  CellPartition cells() const {
    CellPartition cells;
    for (int ring = 0; ring < rings(); ++ring)
      for (int sector = 0; sector < sectors(levels_[ring]); ++sector) cells.push_back(cell(ring, sector));
    return cells;
  }

 private:
  int rings() const { return static_cast<int>(radii_.size()); }
  int sectors(int level) const { return pattern_.sectors << level; }
  int wrapped(int level, int sector) const { return (sector + sectors(level)) % sectors(level); }
  int index(int ring, int sector) const { return first_[ring] + wrapped(levels_[ring], sector); }

  void add_ring(double radius, double width, int level) {
    first_.push_back(first_.empty() ? 0 : first_.back() + sectors(levels_.back()));
    check_cell_count(first_.back() + 2.0 * sectors(level));
    radii_.push_back(radius);
    widths_.push_back(width);
    levels_.push_back(level);
  }

  /// `ray`: 0 to the number of sectors, which is the first one again.
  double angle(int level, int ray) const {
    // The angle between two rays is at least a fifth of its mean.
    const auto shift = [&] {
      return 0.8 * pattern_.jitter * (random_unit(pattern_.seed, wrapped(level, ray), -1 - level) - 0.5);
    };
    if (level == 0 && ray == sectors(0)) return angle(0, 0) + 2 * std::numbers::pi;
    if (level == 0) return 2 * std::numbers::pi * (ray + shift()) / pattern_.sectors;
    if (ray % 2 == 0) return angle(level - 1, ray / 2);
    return std::lerp(angle(level - 1, ray / 2), angle(level - 1, ray / 2 + 1), (1 + shift()) / 2);
  }
  Vec3 direction(int level, int ray) const {
    const double a = angle(level, wrapped(level, ray));
    return std::cos(a) * across_ + std::sin(a) * up_;
  }

  Vec3 node(int ring, int ray) const {
    const int level = levels_[ring];
    const double shift = 0.8 * pattern_.jitter * (random_unit(pattern_.seed, wrapped(level, ray), ring) - 0.5);
    return pattern_.center + (radii_[ring] + shift * widths_[ring]) * direction(level, ray);
  }

  /// Returns the half-space behind a ray, in the direction of growing angles.
  HalfSpace behind_ray(int level, int ray) const {
    const Vec3 normal = pattern_.axis.normalized().cross(direction(level, ray)).normalized();
    return {normal, normal.dot(pattern_.center)};
  }

  HalfSpace within_ring(int ring, int sector) const {
    const Vec3 begin = node(ring, sector), end = node(ring, sector + 1);
    const Vec3 normal = (end - begin).cross(pattern_.axis).normalized();
    return {normal, normal.dot((begin + end) / 2)};
  }

  ConvexCell cell(int ring, int sector) const {
    const int level = levels_[ring];
    ConvexCell cell;
    cell.splinter = index(ring, sector);
    cell.walls.push_back({behind_ray(level, sector).opposite(), index(ring, sector - 1)});
    cell.walls.push_back({behind_ray(level, sector + 1), index(ring, sector + 1)});
    if (ring > 0) {
      const int inner = sector >> (level - levels_[ring - 1]);
      cell.walls.push_back({within_ring(ring - 1, inner).opposite(), index(ring - 1, inner)});
    }
    if (ring + 1 < rings()) {
      const int finer = levels_[ring + 1] - level;
      for (int outer = sector << finer; outer < (sector + 1) << finer; ++outer)
        cell.walls.push_back({within_ring(ring, sector), index(ring + 1, outer)});
    }
    return cell;
  }

  const RadialSplinters& pattern_;
  Vec3 across_, up_;
  std::vector<double> radii_, widths_;  ///< per ring: its outer border, except for the last one, which has none
  std::vector<int> levels_, first_;     ///< per ring: level of its rays; its first cell
};

}  // namespace

CellPartition make_radial_cells(const RadialSplinters& pattern, const Eigen::AlignedBox3d& bounds, double largest) {
  return RadialPattern(pattern, bounds, largest).cells();
}

}  // namespace griffith
