#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/elasticity/element.h"

namespace griffith::app {

/// Mesh of one frame.
struct MeshState {
  std::vector<std::array<NodeId, 4>> tets;
  std::vector<Vec3> positions;  ///< per node [m]
};

/// Origin of a tet of the last state in an earlier one: the tet of the same number or, if remeshing has cut it since,
/// the tet of which it was a part.
struct TetOrigin {
  TetId tet;
  Eigen::Matrix4d weights;  ///< column i: barycentric coordinates of corner i in that tet
};

/// Meshes of a run's frames, for tracking the tets of the last frame back in time.
class MeshHistory {
 public:
  /// `states`: in order of time, the last one with the `rest_positions` of all its nodes [m].
  MeshHistory(std::vector<MeshState> states, std::span<const Vec3> rest_positions);

  const std::vector<MeshState>& states() const { return states_; }
  TetOrigin origin(int state, TetId tet) const;
  /// Returns the positions of the corners of a tet of the last state in another state [m].
  Corners corners(int state, TetId tet) const;
  /// Returns the positions of the nodes of the last state in another state [m]; copies made by later cracks coincide
  /// with their originals.
  std::vector<Vec3> positions(int state) const;

 private:
  void find_parents(const MeshState& before, const MeshState& after);
  Corners rest_corners(const MeshState& state, TetId tet) const;

  std::vector<MeshState> states_;
  std::vector<Vec3> rest_positions_;
  std::vector<TetId> parents_;  ///< per tet made by remeshing: the tet of the previous state from which it was cut
};

}  // namespace griffith::app
