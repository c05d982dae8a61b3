#pragma once

#include "sim/world/world_state.h"

namespace griffith {

/// What moves in a world, as it was when a substep began.
struct Moment {
  /// Of a body.
  struct Piece {
    RigidMotion motion;
    Quat orientation;
    bool rigid = false;
    std::optional<SoftenedImpact> softened;
    double softening = 1;
    std::int64_t last_strike = 0;
  };
  double time = 0;  ///< [s]
  std::vector<Vec3> positions, velocities;
  std::vector<NodeSeparation> separations;
  std::vector<ElementState> states;
  std::vector<Mat3> plastic_strains, stresses;
  std::vector<Piece> pieces;            ///< per body
  std::vector<RigidState> projectiles;  ///< per projectile
  std::size_t contact_views = 0;
  EnergyAccount energy;
};

Moment moment_of(const WorldState& world);

/// Takes the world back to a moment, but for what was cracked since, `cracked` in its order: new nodes are where their
/// originals were. Bodies that woke since stay awake. Not for meshes that were remeshed since. What follows from the
/// nodes of cracked bodies is made anew afterwards, by part_bodies().
void rewind(WorldState& world, const Moment& moment, std::span<const NodeCopy> cracked);

}  // namespace griffith
