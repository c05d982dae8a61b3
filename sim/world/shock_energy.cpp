#include "sim/world/energy_phase.h"
#include "sim/world/phases.h"
#include "sim/world/shock_run.h"

namespace griffith {

/// Elastic energy of slivers that the microsteps do not know of [J].
double ShockRun::relieved_energy() const {
  constexpr double kWhole = 1 - 1e-4;
  double relieved = 0;
  for (std::size_t slot = 0; slot < tets_.size(); ++slot) {
    const TetId tet = tets_[slot];
    if (!tet.valid()) continue;
    const ElementRest& rest = world_.elements.rests[tet];
    const double share = solid_.acting_share(static_cast<int>(slot), rest.volume);
    if (share > kWhole) continue;
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = solid_.position(solid_.corner(static_cast<int>(slot), i));
    const ElasticLaw law = elastic_law(world_.material_of(world_.bodies[world_.elements.bodies[tet]]));
    const ElementState state =
        element_state(law, element_deformation(law.model, rest, corners), world_.elements.plastic_strains[tet]);
    relieved += (1 - share) * rest.volume * state.energy_density;
  }
  return relieved;
}

void ShockRun::begin_account() {
  first_power_ = solid_.power();
  first_relieved_ = relieved_energy();
  first_positions_.clear();
  if (world_.loads.empty()) return;
  for (int i = 0; i < solid_.node_count(); ++i) first_positions_.push_back(solid_.position(i));
}

/// Velocities belong half a microstep before the positions: with the mean velocity of a microstep its forces work as
/// leapfrog sums them up, and what is left is half a microstep's work at both ends.
void ShockRun::book_account() {
  EnergyAccount& energy = world_.energy;
  energy.time_integration += 0.5 * dt_ * (solid_.power() - first_power_);
  energy.contacts += impacts_->take_lost(solid_, dt_);
  energy.microstep_damping += solid_.take_viscous_work();
  energy.hand_over += first_relieved_ - relieved_energy();
  for (const shock::SolidConstraint& held : solid_.constraints())
    energy.supports += held.impulse.dot(held.constraint.velocity);
  for (std::size_t i = 0; i < first_positions_.size(); ++i) {
    const int node = static_cast<int>(i);
    const Vec3 load = (solid_.external_acceleration(node) - world_.scene.gravity) / solid_.node(node).inverse_mass;
    energy.loads += load.dot(solid_.position(node) - first_positions_[i]);
  }
}

}  // namespace griffith
