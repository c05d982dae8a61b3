#pragma once

#include <vector>

#include "sim/world/state/world_state.h"

namespace griffith {

/// Work that a body's deformation by its velocities does against elastic forces, as the linearized step predicts it.
/// Its motion as a whole follows from the balance of momentum alone and does not change them in axes that move along.
struct ElasticWorks {
  double first = 0;   ///< against the forces at the start [J]
  double change = 0;  ///< against their linearized change by the displacement, all of it from the start on [J]
  std::vector<double> energy_densities;  ///< per tet of the body, before it moves [J/m³]
};

/// Returns the works of a substep of `dt` [s], before the body moves.
ElasticWorks elastic_works(const WorldState& world, const Body& body, double dt);
/// Returns the increase of its elastic energy since then [J].
double stored_since(const WorldState& world, const Body& body, const ElasticWorks& works);

/// Returns twice the elastic energy of a stress, per volume [J/m³].
double twice_energy_density(const ElasticLaw& law, const Mat3& stress);

}  // namespace griffith
