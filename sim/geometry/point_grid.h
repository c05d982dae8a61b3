#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Points sorted into equal boxes, for searches in a region.
class PointGrid {
 public:
  /// `edge`: length of the boxes [m], > 0, increased if there would be many more boxes than points. Points that are not
  /// finite may be in any box.
  PointGrid(std::span<const Vec3> points, double edge);

  /// Calls use(index) once for every point in a region, and for some near it. The order depends only on the points and
  /// the region.
  template <class Use>
  void visit(const Eigen::AlignedBox3d& region, Use use) const {
    const std::array<int, 3> first = place_of(region.min()), last = place_of(region.max());
    for (int x = first[0]; x <= last[0]; ++x)
      for (int y = first[1]; y <= last[1]; ++y) {
        const int row = (x * counts_[1] + y) * counts_[2];
        for (int k = starts_[row + first[2]]; k < starts_[row + last[2] + 1]; ++k) use(points_[k]);
      }
  }

 private:
  /// Returns the numbers of boxes of that edge along each axis, limited to a few per point in total.
  static std::array<int, 3> counts_along(const Vec3& sizes, double edge, std::size_t points);
  std::array<int, 3> place_of(const Vec3& point) const;
  int box_of(const Vec3& point) const;

  Vec3 corner_ = Vec3::Zero(), per_length_ = Vec3::Zero();  ///< lower corner [m]; boxes per length [1/m]
  std::array<int, 3> counts_{1, 1, 1};
  std::vector<int> starts_;  ///< per box: start in points_; then the end
  std::vector<int> points_;  ///< indices of points, by box
};

inline std::array<int, 3> PointGrid::counts_along(const Vec3& sizes, double edge, std::size_t points) {
  constexpr double kPerPoint = 4, kMostAlong = 1e6;
  Vec3 counts = Vec3::Ones();
  for (int axis = 0; axis < 3; ++axis)
    if (sizes[axis] > edge) counts[axis] = std::min(std::ceil(sizes[axis] / edge), kMostAlong);
  while (counts.prod() > kPerPoint * static_cast<double>(points) + 1) {
    int longest = 0;
    counts.maxCoeff(&longest);
    counts[longest] = std::ceil(counts[longest] / 2);
  }
  return {static_cast<int>(counts[0]), static_cast<int>(counts[1]), static_cast<int>(counts[2])};
}

inline PointGrid::PointGrid(std::span<const Vec3> points, double edge) : points_(points.size()) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& point : points)
    if (point.allFinite()) bounds.extend(point);
  if (!bounds.isEmpty()) {
    corner_ = bounds.min();
    counts_ = counts_along(bounds.sizes(), edge, points.size());
    for (int axis = 0; axis < 3; ++axis)
      per_length_[axis] = counts_[axis] > 1 ? counts_[axis] / bounds.sizes()[axis] : 0;
  }
  starts_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
  for (const Vec3& point : points) ++starts_[box_of(point) + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  std::vector<int> ends(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) points_[ends[box_of(points[i])]++] = static_cast<int>(i);
}

inline std::array<int, 3> PointGrid::place_of(const Vec3& point) const {
  std::array<int, 3> place{};
  for (int axis = 0; axis < 3; ++axis) {
    const double along = per_length_[axis] * (point[axis] - corner_[axis]);
    if (along > 0) place[axis] = along < counts_[axis] ? static_cast<int>(along) : counts_[axis] - 1;
  }
  return place;
}

inline int PointGrid::box_of(const Vec3& point) const {
  const auto [x, y, z] = place_of(point);
  return (x * counts_[1] + y) * counts_[2] + z;
}

}  // namespace griffith
