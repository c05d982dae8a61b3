#pragma once

#include <span>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/mesh_history.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns the best-fit rigid motions of pieces, per body of the last frame and state from `first`: mass-weighted least
/// squares of the nodes of its tets relative to state `first` (Kabsch 1976). Successive rotations of a piece keep the
/// sign of their quaternions. Empty for a body without tets.
std::vector<std::vector<Pose>> piece_poses(const Frame& last, const MeshHistory& history, int first);

}  // namespace griffith::app
