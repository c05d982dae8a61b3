#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/picture/shown_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Finds the bodies that contain points, with a grid of cells that list their tets.
class BodyCells {
 public:
  /// `region`: contains all queried points.
  BodyCells(const Frame& frame, const HiddenBodies& hidden, const Eigen::AlignedBox3d& region)
      : frame_(frame), region_(region) {
    constexpr double kMaxCells = 64;  // along an edge
    const double edge = std::max(mean_edge(), region.sizes().maxCoeff() / kMaxCells);
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int>(region.sizes()[axis] / edge) + 1;
    edge_ = edge;
    tets_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
    for (const TetId tet : IdRange<TetId>(0, std::ssize(frame.elements.tets)))
      if (!hidden.contains(frame.bodies[frame.elements.bodies[tet]].scene_body)) enter(tet);
  }

  bool hold(const Vec3& place) const {
    if (!region_.contains(place)) return false;
    const std::array<int, 3> cell = cell_of(place);
    return std::ranges::any_of(tets_[flat(cell)], [&](TetId tet) { return holds(tet, place); });
  }

 private:
  /// Returns the edge of a cube of six tets [m].
  double mean_edge() const {
    double volume = 0;
    for (const RestElement& element : frame_.elements.rest_elements) volume += element.volume;
    return std::cbrt(6 * volume / static_cast<double>(std::max<std::size_t>(frame_.elements.tets.size(), 1)));
  }

  void enter(TetId tet) {
    Eigen::AlignedBox3d box;
    for (const NodeId node : frame_.elements.tets[tet]) box.extend(frame_.nodes.positions[node]);
    if (!region_.intersects(box)) return;
    const std::array<int, 3> low = cell_of(box.min()), high = cell_of(box.max());
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) tets_[flat({x, y, z})].push_back(tet);
  }

  bool holds(TetId tet, const Vec3& place) const {
    std::array<Vec3, 4> corners;
    for (int i = 0; i < 4; ++i) corners[i] = frame_.nodes.positions[frame_.elements.tets[tet][i]];
    for (int i = 0; i < 4; ++i) {
      std::array<Vec3, 4> part = corners;
      part[i] = place;
      if (signed_volume(part[0], part[1], part[2], part[3]) < 0) return false;
    }
    return true;
  }

  /// Returns the cell that contains a point, clamped to the grid.
  std::array<int, 3> cell_of(const Vec3& place) const {
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<int>(std::clamp((place[axis] - region_.min()[axis]) / edge_, 0.0, size_[axis] - 1.0));
    return cell;
  }
  std::size_t flat(const std::array<int, 3>& cell) const {
    return static_cast<std::size_t>(cell[0] + size_[0] * (cell[1] + size_[1] * cell[2]));
  }

  const Frame& frame_;
  Eigen::AlignedBox3d region_;
  std::array<int, 3> size_;
  double edge_ = 1;                       ///< edge of a cell [m]
  std::vector<std::vector<TetId>> tets_;  ///< per cell
};

}  // namespace griffith::app
