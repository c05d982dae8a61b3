#include <algorithm>
#include <cmath>

#include "sim/world/bodies/effective_law.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the elastic energy of relieved slivers that microsteps do not know of [J]: of those without stiffness, which
/// is lost at the start; of the others, over whose strains a lower stress does more work, a negative one.
double ExplicitRun::relieved_energy(bool at_start) const {
  double relieved = 0;
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    if (!tets_[slot].valid() || !explicit_bodies_.is_relieved(slot)) continue;
    const double stiffness = explicit_bodies_.stiffness(slot);
    if (stiffness == 0 && !at_start) continue;
    const TetId tet = tets_[slot];
    const Body& body = world_.bodies[world_.elements.bodies[tet]];
    const RestElement& rest = world_.elements.rest_elements[tet];
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = explicit_bodies_.position(explicit_bodies_.corner(slot, i));
    const ElasticLaw law = effective_elastic_law(world_, body);
    const ElementDeformation deformation = element_deformation(law.model, rest, corners);
    const Mat3 permanent = stiffness == 0 ? world_.elements.stress_free_strain(tet)
                                          : deformation.strain - elastic_strain(tet, deformation.strain);
    const double known = stiffness == 0 ? 0 : 1 / stiffness;
    relieved += (1 - known) * rest.volume * body.explicit_state->similarity *
                element_state(law, deformation, permanent).energy_density;
  }
  return relieved;
}

/// Adds the works of loads that do not change any more, and of what scaling leaves out of them and of weight.
void ExplicitRun::add_external_works(EnergyAccount& spent) const {
  const bool scaled =
      std::ranges::any_of(bodies_, [&](BodyId id) { return world_.bodies[id].explicit_state->similarity < 1; });
  if (!scaled && world_.loads.empty()) return;
  const auto add = [&](const Start& start, double mass, const Vec3& weight, const Vec3& position) {
    const Vec3 displacement = position - start.position;
    if (!world_.loads.empty()) spent.loads += mass * (start.steady.whole - weight).dot(displacement);
    if (scaled) spent.scaling += mass * (start.steady.whole - start.steady.acting).dot(displacement);
  };
  for (int i = 0; i < explicit_bodies_.node_count(); ++i)
    add(starts_[i], 1 / explicit_bodies_.node(i).inverse_mass, world_.model->scene.gravity,
        explicit_bodies_.position(i));
  for (int i = 0; i < explicit_bodies_.edge_count(); ++i)
    add(edge_starts_[i], 1 / explicit_bodies_.edge(i).inverse_mass, Vec3::Zero(), explicit_bodies_.edge_offset(i));
}

/// Begins with the forces of the first microstep.
void ExplicitRun::begin_account() {
  first_.time_integration = explicit_bodies_.half_kick_energy();
  first_.regime_change = relieved_energy(true);
}

/// Accounts for forces that act between microsteps of different lengths, in place of end_account() and begin_account().
void ExplicitRun::account_change_of_microstep(double previous_dt) {
  if (previous_dt == dt_) return;
  const double ratio = previous_dt / dt_;
  first_.time_integration += (1 - ratio * ratio) * explicit_bodies_.half_kick_energy();
}

/// Ends with the forces at the end. The forces of each microstep do work over half of the displacements before and
/// after it, whose sum is the decrease of elastic energy. The remaining half kicks at both ends are the difference
/// between the energy and that which the microsteps conserve.
void ExplicitRun::end_account() {
  EnergyAccount spent;
  spent.time_integration = first_.time_integration - explicit_bodies_.half_kick_energy();
  spent.regime_change = first_.regime_change - relieved_energy(false);
  spent.contacts = contacts_->lost(explicit_bodies_, dt_);
  spent.fracture = contacts_->fractured();
  spent.microstep_damping = explicit_bodies_.viscous_work();
  for (const explicit_dynamics::ExplicitConstraint& held : explicit_bodies_.constraints()) spent.supports += held.work;
  add_external_works(spent);
  for (ChangingLoad& changing : changing_loads_) account_loads(changing, changing.factor, 0);
  spent += work_of_changing_loads_;
  if (std::isfinite(spent.lost()) && std::isfinite(spent.put_in())) world_.energy += spent;
}

}  // namespace griffith
