#pragma once

#include <span>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/mesh_history.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Strength over the tensile strength of each node [-], as flaws scatter it. `start`: the world's first frame.
std::vector<double> strength_factors_at_start(const Frame& start, const Scene& scene);

/// What bonds are made from: the run's meshes, of which state 0 is the world's first frame and state 1 the first one
/// that is baked.
struct BondInput {
  const Frame& last;
  const MeshHistory& history;
  std::span<const double> strength_factors;  ///< per node of state 0
  std::span<const int> thing_of_body;        ///< per BodyId of `last`
  double opened_before = 0;                  ///< faces that opened until then held nothing in the first frame [s]
};

/// Finds the faces through which pieces held together at the start, by what cracks have opened since. Where remeshing
/// has cut the two sides of a crack differently, each face counts for the one beyond its middle.
std::vector<BakedBond> piece_bonds(const BondInput& input);

}  // namespace griffith::app
