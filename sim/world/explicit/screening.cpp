#include "sim/world/explicit/screening.h"

#include <algorithm>
#include <limits>

#include "sim/fracture/crack_front.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Safety factor of screening: the stress of elements is that of another frame than in the check of nodes.
constexpr float kScreeningFraction = 0.97F;
/// Largest stress or equivalent tension of the elements around a node over its load, at least: of the load, their mean
/// equivalent tension is one part, and what the plane's stress exceeds that of the mean the other.
constexpr double kSurfaceFraction = 0.5;

/// Returns the least energy that a crack through a node takes per area, in any direction [J/m²].
double least_fracture_energy(const WorldState& world, NodeId node) {
  const Body& body = body_at(world, node);
  const auto& weakness = world.model->weaknesses[body.scene_body];
  return fracture_energy(world.material_of(body), weakness ? weakness->strength_ratio : 1);
}

}  // namespace

float screening_stress(const WorldState& world, NodeId node, bool at_front) {
  const Body& body = body_at(world, node);
  const Material& material = world.material_of(body);
  if (!world.model->scene.simulation.fracture) return std::numeric_limits<float>::infinity();
  if (world.mesh->stars[node].size() == 1 && world.nodes.has_support[node] == 0)  // a tip: nothing to part
    return std::numeric_limits<float>::infinity();
  const FractureLaw& law = fracture_law(material);
  double minimum = screening_resistance_at(world, material, node, at_front);
  if (const auto& weakness = world.model->weaknesses[body.scene_body]) minimum *= weakness->strength_ratio;
  if (!law.is_stress()) {
    double area = 0;  // v⁺ is at most half the sum of the tensile forces
    for (const TetId tet : world.mesh->stars[node])
      area += world.elements.rest_elements[tet].volume *
              world.elements.rest_elements[tet].shape_gradients.col(local_corner(world.mesh, tet, node)).norm();
    minimum *= 2 / area;
  }
  if (law.strength_ratio) minimum *= kSurfaceFraction;
  return kScreeningFraction * static_cast<float>(minimum);
}

/// Returns energy_release_bound() of a node under the last forces.
double ExplicitRun::energy_release_bound_at(int index) const {
  const NodeId node = nodes_[index];
  std::vector<Corners> star;
  std::vector<Vec3> forces;
  for (const TetId tet : world_.mesh->stars[node]) {
    const int slot = slot_of_tet_[tet];
    Corners& corners = star.emplace_back();
    for (int i = 0; i < 4; ++i) corners.col(i) = explicit_bodies_.position(explicit_bodies_.corner(slot, i));
    forces.push_back(explicit_bodies_.force(4 * slot + local_corner(world_.mesh, tet, node)));
  }
  return energy_release_bound(world_.mesh, node, star, forces);
}

/// True if a flagged node may be overloaded. A node of a crack front needs enough stress, or enough energy.
bool ExplicitRun::can_be_overloaded(int index) const {
  const NodeId node = nodes_[index];
  if (time_ < world_.nodes.overloads[node].known_from) return false;
  if (world_.nodes.at_crack_front[node] == 0) return true;
  const double by_stress = body_of(node).explicit_state->similarity * screening_stress(world_, node, false);
  return explicit_bodies_.flagging_stress(index) > by_stress ||
         energy_release_bound_at(index) > least_fracture_energy(world_, node);
}

}  // namespace griffith
