#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "sim/explicit/explicit_bodies.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// World's counterpart of each part of explicit bodies.
struct TrialParts {
  std::vector<NodeId> nodes;              ///< per explicit node
  std::vector<TetId> tets;                ///< per slot; invalid in unused ones
  std::vector<std::array<int, 6>> edges;  ///< per slot, of quadratic tets: explicit edges; empty without any
  std::vector<Mat3> turns;                ///< per explicit body, from its place at rest
};

/// Utilization of explicit nodes that move apart from the world, as in ExplicitRun, without writing to the world.
class TrialLoads {
 public:
  TrialLoads(const WorldState& world, const explicit_dynamics::ExplicitBodies& explicit_bodies,
             const TrialParts& parts);
  /// Marks the states of all elements as outdated, after they have moved.
  void forget() { std::fill(is_known_.begin(), is_known_.end(), false); }
  /// Returns the utilization of a node by the present stresses of the elements around it.
  double utilization(int node);

 private:
  void find_state(int slot);
  double energy_release(int node, const Vec3& normal) const;
  Corners corners(int slot) const;

  const WorldState& world_;
  const explicit_dynamics::ExplicitBodies& explicit_bodies_;
  const TrialParts& parts_;
  std::vector<std::array<NodeId, 4>> tets_;   ///< per slot, explicit nodes
  std::vector<std::vector<TetId>> stars_;     ///< per explicit node, slots
  std::vector<RestElement> rest_elements_;    ///< per slot
  std::vector<ElementState> states_;          ///< per slot
  std::vector<bool> is_known_;                ///< per slot: its state is that of now
  std::vector<NodeConstraint> constraints_;   ///< per explicit node
  std::vector<std::array<EdgeId, 6>> edges_;  ///< per slot
  std::vector<QuadraticState> quadratic_states_;
};

}  // namespace griffith
