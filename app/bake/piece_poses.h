#pragma once

#include <span>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/mesh_history.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The rigid motions that fit those of pieces best, per body of the last frame and state from `first`: mass-weighted
/// least squares of the nodes of its tets (Kabsch 1976) from where they were in state `first`. Rotations of one
/// piece follow each other without a change of sign. Empty for a body without tets.
std::vector<std::vector<Pose>> piece_poses(const Frame& last, const MeshHistory& history, int first);

}  // namespace griffith::app
