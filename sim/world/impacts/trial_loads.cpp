#include "sim/world/impacts/trial_loads.h"

#include <algorithm>
#include <cmath>

#include "sim/fracture/crack_front.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/fracture/separation_phase.h"

namespace griffith {

TrialLoads::TrialLoads(const WorldState& world, const explicit_dynamics::ExplicitBodies& explicit_bodies,
                       const TrialParts& parts)
    : world_(world),
      explicit_bodies_(explicit_bodies),
      parts_(parts),
      tets_(parts.tets.size()),
      stars_(parts.nodes.size()),
      is_known_(parts.tets.size(), false) {
  const bool is_quadratic = !parts.edges.empty();
  rest_elements_.resize(tets_.size(), RestElement{Corners::Zero(), 0});
  states_.resize(tets_.size());
  if (is_quadratic) edges_.resize(tets_.size()), quadratic_states_.resize(tets_.size());
  for (int slot = 0; slot < static_cast<int>(tets_.size()); ++slot) {
    const TetId tet = parts.tets[slot];
    if (!tet.valid()) continue;
    rest_elements_[slot] = world.elements.rest_elements[tet];
    if (is_quadratic) edges_[slot] = world.tet_edges->of_tet[tet];
    for (int i = 0; i < 4; ++i) {
      tets_[slot][i] = NodeId(explicit_bodies.corner(slot, i));
      stars_[explicit_bodies.corner(slot, i)].push_back(TetId(slot));
    }
  }
  for (const NodeId node : parts.nodes) constraints_.push_back(world.nodes.constraints[node]);
}

/// Finds the state of a tet as it is now.
void TrialLoads::find_state(int slot) {
  if (is_known_[slot]) return;
  is_known_[slot] = true;
  const TetId tet = parts_.tets[slot];
  const Material& material = world_.material_of(world_.bodies[world_.elements.bodies[tet]]);
  const ElasticLaw law = elastic_law(material);
  const Corners corners = this->corners(slot);
  if (world_.tet_edges->is_quadratic(tet)) {
    EdgeVectors offsets;
    for (int i = 0; i < 6; ++i) offsets.col(i) = explicit_bodies_.edge_offset(parts_.edges[slot][i]);
    const QuadraticStates found =
        quadratic_states(law, rest_elements_[slot], corners, offsets, world_.elements.corner_stress_free_strains(tet),
                         plastic_law(material));
    states_[slot] = found.mean;
    quadratic_states_[slot] = found.state;
    return;
  }
  const ElementDeformation deformation = element_deformation(law.model, rest_elements_[slot], corners);
  Mat3 permanent = world_.elements.stress_free_strain(tet);
  if (explicit_bodies_.is_relieved(slot)) {
    const Mat3& turn = parts_.turns[explicit_bodies_.body_of_slot(slot)];
    const Mat3 turned = turn * deformation.strain * turn.transpose();
    permanent = deformation.strain - turn.transpose() * explicit_bodies_.elastic_strain(slot, turned) * turn;
  }
  states_[slot] = element_state(law, deformation, permanent);
}

double TrialLoads::utilization(int index) {
  for (const TetId slot : stars_[index]) find_state(slot.index());
  const NodeId node = parts_.nodes[index];
  const Body& body = body_at(world_, node);
  const Material& material = world_.material_of(body);
  const SeparationInput input{tets_, stars_, rest_elements_, states_, constraints_, edges_, quadratic_states_};
  const NodeId local(index);
  const std::optional<Weakness>& weakness = world_.model->weaknesses[body.scene_body];
  DirectionalStrength strength;
  if (weakness) strength = strength_at(input, local, *weakness);
  const CandidatePlane plane =
      candidate_planes(node_loads(input, std::span(&local, 1)), {strength, strength, strength, strength})[0];
  const FractureLaw& law = fracture_law(material);
  const double fraction = strength.fraction(plane.normal);
  const double utilization =
      law.load(input, local, material, plane) / (fraction * resistance(material, world_.nodes.strength_factors[node]));
  if (!law.is_stress() || world_.nodes.at_crack_front[node] == 0) return utilization;
  return std::max(utilization, std::sqrt(energy_release(index, plane.normal) / fracture_energy(material, fraction)));
}

/// Returns the energy release rate of a crack that advances across a plane through a node [J/m²].
double TrialLoads::energy_release(int index, const Vec3& normal) const {
  const NodeId node = parts_.nodes[index];
  std::vector<Corners> star;
  std::vector<Vec3> forces;
  for (const TetId slot : stars_[index]) {
    star.push_back(corners(slot.index()));
    forces.push_back(
        corner_force(rest_elements_[slot], states_[slot], local_corner(world_.mesh, parts_.tets[slot.index()], node)));
  }
  const Vec3 offset = states_[stars_[index].front().index()].frame * world_.nodes.path_offsets[node];
  return best_advance(world_.mesh, node, star, forces, normal, offset).energy_release;
}

Corners TrialLoads::corners(int slot) const {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = explicit_bodies_.position(explicit_bodies_.corner(slot, i));
  return corners;
}

}  // namespace griffith
