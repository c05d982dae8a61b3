#pragma once

#include <span>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/mesh_history.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns the ratio of strength to mean tensile strength of each node [-], due to the scatter of flaws. `start`: the
/// world's first frame.
std::vector<double> strength_factors_at_start(const Frame& start, const Scene& scene);

/// Input of piece_bonds(): meshes of the run, with the world's first frame as state 0 and the first baked frame as
/// state 1.
struct BondInput {
  const Frame& last;
  const MeshHistory& history;
  std::span<const double> strength_factors;  ///< per node of state 0
  std::span<const int> object_of_body;       ///< per BodyId of `last`
  double opened_before = 0;                  ///< faces opened until then are no bonds [s]
};

/// Finds the faces that connected pieces at the start, from all faces opened by cracks since. If remeshing has cut the
/// two sides of a crack differently, each face counts for the piece beyond its center.
std::vector<BakedBond> piece_bonds(const BondInput& input);

}  // namespace griffith::app
