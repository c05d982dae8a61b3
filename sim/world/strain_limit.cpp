#include "sim/world/strain_limit.h"

#include <algorithm>

#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/state/corners.h"

namespace griffith {
namespace {

/// True for bodies whose strains limit substeps: soft ones that are more than debris.
bool limits_substeps(const WorldState& world, const Body& body) {
  return can_be_compacted(world, body) && deforms_visibly(world, body);
}

/// Returns the time in which a body with compacted tets strains by a half [s]: longer substeps would be in vain.
double time_of_strains(const WorldState& world) {
  constexpr double kStrain = 0.5;
  double fastest = 0;
  for (const Body& body : world.bodies) {
    const auto is_compacted = [&](TetId tet) { return world.elements.states[tet].is_compacted(); };
    if (!limits_substeps(world, body) || std::ranges::none_of(body.tets, is_compacted)) continue;
    for (const TetId tet : body.tets) {
      const Mat3 rate =
          deformation_gradient(world.elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.velocities));
      fastest = std::max(fastest, 0.5 * (rate + rate.transpose()).norm());
    }
  }
  return kStrain / fastest;
}

}  // namespace

SubstepLimit strain_limit(const WorldState& world, double time_step) {
  constexpr double kMostSubsteps = 64, kMostIfHeld = 256;
  const double shortest = time_step / kMostSubsteps;
  return {std::max(2 * shortest, time_of_strains(world)), shortest, time_step / kMostIfHeld, time_step};
}

double depth_of_soft_bodies(const WorldState& world) {
  if (!world.model->scene.ground) return 0;
  const double height = world.model->scene.ground->height;
  double deepest = 0;
  for (const Body& body : world.bodies) {
    if (!limits_substeps(world, body) || body.supported()) continue;
    const double rest = height - world.contact_world.overlap_at_rest(body.proxy);
    for (const NodeId node : body.nodes)
      deepest = std::max(deepest, (rest - world.nodes.positions[node].y()) / body.element_size);
  }
  return deepest;
}

}  // namespace griffith
