#include "sim/world/motion/explicit_integration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "sim/core/parallel.h"
#include "sim/mesh/topology.h"
#include "sim/solver/explicit_step.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Largest number of substeps in a step.
constexpr double kMaxSubsteps = 1e5;

/// Returns the highest frequency of a body's present shape with a material [rad/s].
double frequency_of(const WorldState& world, const Body& body, const Material& material) {
  ElasticSystem system = *body.system;
  system.assemble(MatrixFactors{.mass = 0, .stiffness = 1}, elastic_law(material), world.elements.rest_elements,
                  world.elements.states, world.nodes.positions, world.nodes.masses, world.edges.masses);
  const double density_ratio = material.density / world.material_of(body).density;
  return highest_frequency(system.matrix(),
                           density_ratio * system.gather_masses(world.nodes.masses, world.edges.masses));
}

/// Returns the longest stable substep for a body with this highest frequency [rad/s] under explicit integration [s].
double stable_substep_at(double frequency, const Material& material) {
  // Strains of some percent raise frequencies; at half the step of the undeformed body the energy stays within 10 %.
  constexpr double kFraction = 0.5;
  return kFraction * stable_time_step(frequency, material.stiffness_damping);
}

/// Returns Rayleigh's damping of the stiffness, −beta K v, element by element: the forces of beta times the rate of
/// stress.
Vec3 damping_force(const WorldState& world, const ElasticLaw& law, double stiffness_damping, TetId tet, int corner) {
  const RestElement& rest = world.elements.rest_elements[tet];
  const Mat3& frame = world.elements.states[tet].frame;
  const Corners velocities = corners_of(world.mesh, tet, world.nodes.velocities);
  const Mat3 rate = frame.transpose() * deformation_gradient(rest, velocities);
  const Mat3 strain_rate = 0.5 * (rate + rate.transpose());
  Mat3 stress_rate = 2 * law.mu * strain_rate;
  stress_rate.diagonal().array() += law.lambda * strain_rate.trace();
  return -rest.volume * stiffness_damping * (frame * (stress_rate * rest.shape_gradients.col(corner)));
}

/// Does the same for a quadratic body, including its edges.
void add_quadratic_damping(WorldState& world, const Body& body, const ElasticLaw& law, std::vector<Vec3>& forces) {
  const double damping = world.material_of(body).stiffness_damping;
  for (const TetId tet : body.tets) {
    const QuadraticForces of_tet = quadratic_damping_forces(
        law, world.elements.rest_elements[tet], world.elements.states[tet].frame,
        corners_of(world.mesh, tet, world.nodes.velocities), edges_of(world.tet_edges, tet, world.edges.velocities));
    for (int i = 0; i < 4; ++i) forces[world.mesh->tets[tet][i]] += damping * of_tet.corners.col(i);
    for (int i = 0; i < 6; ++i)
      world.scratch.edge_forces[world.tet_edges->of_tet[tet][i]] += damping * of_tet.edges.col(i);
  }
}

void add_damping_forces(WorldState& world, const Body& body, std::vector<Vec3>& forces) {
  const Material& material = world.material_of(body);
  if (material.stiffness_damping == 0) return;
  const ElasticLaw law = elastic_law(material);
  if (!body.edges.empty()) return add_quadratic_damping(world, body, law, forces);
  parallel_for(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (TetId tet : world.mesh->stars[body.nodes[i]])
        forces[body.nodes[i]] +=
            damping_force(world, law, material.stiffness_damping, tet, local_corner(world.mesh, tet, body.nodes[i]));
  });
}

/// Moves the edges of a quadratic body, within the constraints common to both of their ends.
void step_edges(WorldState& world, const Body& body, double dt) {
  const double mass_damping = world.material_of(body).mass_damping;
  for (const EdgeId edge : body.edges) {
    const auto& [a, b] = world.tet_edges->ends[edge];
    const NodeConstraint constraint = constraint_between(world.nodes.constraints[a], world.nodes.constraints[b]);
    Vec3& velocity = world.edges.velocities[edge];
    velocity += dt * (world.scratch.edge_forces[edge] / world.edges.masses[edge] - mass_damping * velocity);
    velocity = (constraint.allowed * velocity).eval();
  }
}

}  // namespace

double stable_substep(WorldState& world) {
  double stable = std::numeric_limits<double>::infinity();
  for (Body& body : world.bodies) {
    if (body.rigid) continue;
    if (body.highest_frequency == 0) body.highest_frequency = frequency_of(world, body, world.material_of(body));
    const double substep = stable_substep_at(body.highest_frequency, world.material_of(body));
    if (world.model->scene.simulation.time_step <= kMaxSubsteps * substep) {
      stable = std::min(stable, substep);
    } else {
      freeze(world, body);
    }
  }
  return stable;
}

void check_substep_count(const WorldState& world, int scene_body, const Material& material) {
  if (!world.integrates_explicitly()) return;
  const double time_step = world.model->scene.simulation.time_step;
  for (const Body& body : world.bodies) {
    if (body.scene_body != scene_body || (body.rigid && body.tets.size() == 1)) continue;
    const double substep = stable_substep_at(frequency_of(world, body, material), material);
    if (time_step <= kMaxSubsteps * substep) continue;  // false for what is not a number, too
    char problem[120];
    std::snprintf(problem, sizeof problem, "explicit integration would take %.3g substeps a step", time_step / substep);
    throw InputError("#/bodies/" + std::to_string(scene_body) + "/material", problem,
                     "at most 100,000 are made: take the implicit integrator, a shorter time step, less stiffness or "
                     "less stiffness_damping");
  }
}

void predict_explicitly(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt) {
  add_damping_forces(world, body, forces);
  std::vector<Vec3> before;
  for (NodeId node : body.system->supports()) before.push_back(world.nodes.velocities[node]);
  explicit_step(dt, world.material_of(body).mass_damping, body.nodes, world.nodes.constraints, world.nodes.masses,
                forces, world.nodes.velocities);
  step_edges(world, body, dt);
  // What the supports did is what the momentum of their nodes lacks.
  for (std::size_t i = 0; i < before.size(); ++i) {
    const NodeId node = body.system->supports()[i];
    world.nodes.reactions[node] =
        world.nodes.masses[node] / dt * (world.nodes.velocities[node] - before[i]) - forces[node];
  }
}

}  // namespace griffith
