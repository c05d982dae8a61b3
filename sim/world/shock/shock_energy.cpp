#include <algorithm>
#include <cmath>

#include "sim/world/energy/energy_phase.h"
#include "sim/world/shock/shock_run.h"
#include "sim/world/shock/similarity.h"
#include "sim/world/world_state.h"

namespace griffith {

/// What of the elastic energy of relieved slivers the microsteps do not know of [J]: that of those without stiffness,
/// which is lost at the start; of the others, over whose strains a lower stress works more, less than nothing.
double ShockRun::relieved_energy(bool at_start) const {
  double relieved = 0;
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    if (!tets_[slot].valid() || !solid_.is_relieved(slot)) continue;
    const double stiffness = solid_.stiffness(slot);
    if (stiffness == 0 && !at_start) continue;
    const TetId tet = tets_[slot];
    const Body& body = world_.bodies[world_.elements.bodies[tet]];
    const RestElement& rest = world_.elements.rest_elements[tet];
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = solid_.position(solid_.corner(slot, i));
    const ElasticLaw law = law_in_shock(world_, body);
    const ElementDeformation deformation = element_deformation(law.model, rest, corners);
    const Mat3 permanent = stiffness == 0 ? world_.elements.stress_free_strain(tet)
                                          : deformation.strain - elastic_strain(tet, deformation.strain);
    const double known = stiffness == 0 ? 0 : 1 / stiffness;
    relieved +=
        (1 - known) * rest.volume * body.shock->similarity * element_state(law, deformation, permanent).energy_density;
  }
  return relieved;
}

/// Adds the works of loads that do not change any more, and of what scaling leaves out of them and of weight.
void ShockRun::add_external_works(EnergyAccount& spent) const {
  const bool scaled = std::ranges::any_of(bodies_, [&](BodyId id) { return world_.bodies[id].shock->similarity < 1; });
  if (!scaled && world_.loads.empty()) return;
  for (int i = 0; i < solid_.node_count(); ++i) {
    const Vec3 displacement = solid_.position(i) - starts_[i].position;
    const double mass = 1 / solid_.node(i).inverse_mass;
    if (!world_.loads.empty())
      spent.loads += mass * (starts_[i].steady.whole - world_.model->scene.gravity).dot(displacement);
    if (scaled) spent.scaling += mass * (starts_[i].steady.whole - starts_[i].steady.acting).dot(displacement);
  }
}

/// Begins with the forces of the first microstep.
void ShockRun::begin_account() {
  first_.time_integration = solid_.half_kick_energy();
  first_.hand_over = relieved_energy(true);
}

/// Ends with the forces at the end. Those of each microstep work over half of the displacements before and after it,
/// which adds up to what elastic energy falls by: what is left are the half kicks at both ends, by as much as which the
/// energy differs from that which the microsteps keep.
void ShockRun::book_account() {
  EnergyAccount spent;
  spent.time_integration = first_.time_integration - solid_.half_kick_energy();
  spent.hand_over = first_.hand_over - relieved_energy(false);
  spent.contacts = impacts_->lost(solid_, dt_);
  spent.fracture = impacts_->fractured();
  spent.microstep_damping = solid_.viscous_work();
  for (const shock::SolidConstraint& held : solid_.constraints()) spent.supports += held.work;
  add_external_works(spent);
  for (Course& course : courses_) book_loads(course, course.factor, 0);
  spent += of_courses_;
  if (std::isfinite(spent.lost()) && std::isfinite(spent.put_in())) world_.energy += spent;
}

}  // namespace griffith
