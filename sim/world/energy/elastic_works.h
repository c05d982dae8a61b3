#pragma once

#include <vector>

#include "sim/world/world_state.h"

namespace griffith {

/// What elastic forces do to a body over the way by its solved velocities, as the linearised step knows them.
struct ElasticWorks {
  double first = 0;                      ///< against the forces at the start [J]
  double change = 0;                     ///< against their linearised change, all of it over all of the way [J]
  std::vector<double> energy_densities;  ///< per tet of the body, before it moves [J/m³]
};

/// Works of a substep of `dt` [s], before the body moves.
ElasticWorks elastic_works(const WorldState& world, const Body& body, double dt);
/// What its elastic energy has grown by since [J].
double stored_since(const WorldState& world, const Body& body, const ElasticWorks& works);

/// Twice the elastic energy of a stress, per volume [J/m³].
double twice_energy_density(const ElasticLaw& law, const Mat3& stress);

}  // namespace griffith
