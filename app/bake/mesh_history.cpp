#include "app/bake/mesh_history.h"

#include <limits>

#include "app/bake/barycentric.h"

namespace griffith::app {
MeshHistory::MeshHistory(std::vector<MeshState> states, std::span<const Vec3> rest_positions)
    : states_(std::move(states)),
      rest_positions_(rest_positions.begin(), rest_positions.end()),
      parents_(states_.back().tets.size()) {
  for (std::size_t i = 1; i < states_.size(); ++i)
    if (states_[i].tets.size() > states_[i - 1].tets.size()) find_parents(states_[i - 1], states_[i]);
}

Corners MeshHistory::rest_corners(const MeshState& state, TetId tet) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = rest_positions_[state.tets[tet][i]];
  return corners;
}

/// A tet that was cut out of another lies in it at rest, and reduced it.
void MeshHistory::find_parents(const MeshState& before, const MeshState& after) {
  std::vector<TetId> cut;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(before.tets)))
    if (rest_corners(before, tet) != rest_corners(after, tet)) cut.push_back(tet);
  for (const TetId tet : IdRange<TetId>(std::ssize(before.tets), std::ssize(after.tets))) {
    const Vec3 middle = rest_corners(after, tet).rowwise().mean();
    double deepest = -std::numeric_limits<double>::infinity();
    for (const TetId candidate : cut) {
      const double depth = barycentric(rest_corners(before, candidate), middle).minCoeff();
      if (depth > deepest) deepest = depth, parents_[tet] = candidate;
    }
  }
}

TetOrigin MeshHistory::origin(int state, TetId tet) const {
  const MeshState& then = states_[state];
  TetId origin = tet;
  while (origin.index() >= std::ssize(then.tets)) origin = parents_[origin];
  const Corners now_at_rest = rest_corners(states_.back(), tet), then_at_rest = rest_corners(then, origin);
  if (now_at_rest == then_at_rest) return {origin, Eigen::Matrix4d::Identity()};
  return {origin, barycentric(then_at_rest, now_at_rest)};
}

Corners MeshHistory::corners(int state, TetId tet) const {
  const TetOrigin from = origin(state, tet);
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = states_[state].positions[states_[state].tets[from.tet][i]];
  return corners * from.weights;
}

std::vector<Vec3> MeshHistory::positions(int state) const {
  std::vector<Vec3> positions(rest_positions_.size());
  const auto& tets = states_.back().tets;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(tets))) {
    const Corners at = corners(state, tet);
    for (int i = 0; i < 4; ++i) positions[tets[tet][i]] = at.col(i);
  }
  return positions;
}

}  // namespace griffith::app
