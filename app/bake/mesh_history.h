#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/elasticity/element.h"

namespace griffith::app {

/// The mesh as it was in one frame.
struct MeshState {
  std::vector<std::array<NodeId, 4>> tets;
  std::vector<Vec3> positions;  ///< per node [m]
};

/// Where a tet of the last state comes from in an earlier one: from the tet of the same number, or, where remeshing
/// has cut it since, from the one that it was a part of.
struct TetOrigin {
  TetId tet;
  Eigen::Matrix4d weights;  ///< column i: corner i in barycentric coordinates of that tet
};

/// The meshes of a run's frames, and how the tets of the last one got where they are.
class MeshHistory {
 public:
  /// `states`: in time, the last one with `rest_positions` of all its nodes [m].
  MeshHistory(std::vector<MeshState> states, std::span<const Vec3> rest_positions);

  const std::vector<MeshState>& states() const { return states_; }
  TetOrigin origin(int state, TetId tet) const;
  /// Where the corners of a tet of the last state were [m].
  Corners corners(int state, TetId tet) const;
  /// Where the nodes of the last state were [m]: copies that cracks made later lie on their originals.
  std::vector<Vec3> positions(int state) const;

 private:
  void find_parents(const MeshState& before, const MeshState& after);
  Corners rest_corners(const MeshState& state, TetId tet) const;

  std::vector<MeshState> states_;
  std::vector<Vec3> rest_positions_;
  std::vector<TetId> parents_;  ///< per tet that remeshing made: the one of the state before that it was cut out of
};

}  // namespace griffith::app
