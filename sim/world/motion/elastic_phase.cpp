#include "sim/world/motion/elastic_phase.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/elasticity/corner_traction.h"
#include "sim/elasticity/plasticity.h"
#include "sim/mesh/corner_sums.h"
#include "sim/solver/pivot.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/bodies/quadratic_states.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/motion/explicit_integration.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/motion/turning.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/element_states.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Adds elastic and external forces of the body's nodes, per node of the mesh. Writes only the body's own entries, also
/// those of `sums`.
void add_linear_forces(const WorldState& world, const Body& body, std::span<simd::WideQuad> sums,
                       std::vector<Vec3>& forces) {
  const ElementArrays& elements = world.elements;
  const ElementModel model = world.material_of(body).element_model;
  const auto add = [&](TetId tet, const std::array<simd::WideQuad*, 4>& to) {
    const RestElement& rest = elements.rest_elements[tet];
    const CornerVectors gradients = corner_gradients(rest);
    CornerVectors tractions = corner_tractions(elements.states[tet], gradients);
    if (!elements.stress_free_strain(tet).isZero(0)) {
      const Corners corners = corners_of(world.mesh, tet, world.nodes.positions);
      tractions = tractions + product(turning_traction(model, rest, corners, elements.states[tet]), gradients);
    }
    const auto at_corners = one_by_one(tractions);
    for (int i = 0; i < 4; ++i) *to[i] -= rest.volume * at_corners[i];
  };
  parallel_parts(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    const std::span<const NodeId> nodes = std::span(body.nodes).subspan(begin, end - begin);
    for (const NodeId node : nodes) sums[node] = simd::WideQuad{};
    add_at_corners<simd::WideQuad>(world.mesh->tets, body.tets, nodes, sums, add);
    for (const NodeId node : nodes) forces[node] += Vec3(sums[node][0], sums[node][1], sums[node][2]);
  });
}

/// Does the same for a quadratic body, and sets the elastic forces of its edges, per edge of the mesh [N].
void add_quadratic_forces(const WorldState& world, const Body& body, std::vector<Vec3>& forces,
                          std::vector<Vec3>& edge_forces) {
  const ElementArrays& elements = world.elements;
  std::vector<QuadraticForces> of_tets(body.tets.size());
  parallel_for(static_cast<int>(body.tets.size()), 512, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      of_tets[i] = quadratic_forces(elements.rest_elements[body.tets[i]], elements.quadratic_states[body.tets[i]]);
  });
  for (const EdgeId edge : body.edges) edge_forces[edge].setZero();
  for (std::size_t i = 0; i < body.tets.size(); ++i) {
    const std::array<NodeId, 4>& corners = world.mesh->tets[body.tets[i]];
    const std::array<EdgeId, 6>& edges = world.tet_edges->of_tet[body.tets[i]];
    for (int k = 0; k < 4; ++k) forces[corners[k]] += of_tets[i].corners.col(k);
    for (int k = 0; k < 6; ++k) edge_forces[edges[k]] += of_tets[i].edges.col(k);
  }
}

}  // namespace

void add_elastic_forces(const WorldState& world, const Body& body, std::vector<Vec3>& forces, Scratch& scratch) {
  if (body.edges.empty()) {
    add_linear_forces(world, body, scratch.elastic_forces, forces);
  } else {
    add_quadratic_forces(world, body, forces, scratch.edge_forces);
  }
}

namespace {

/// Removes the torque of the elastic forces from the `forces` on a body that turns freely or about a pivot; `outer`:
/// the other ones, per node of the body [N]. Forces on the edges of quadratic tets have one, which their nodes balance.
void remove_inner_torque(const WorldState& world, const Body& body, const NodeVectors& outer,
                         std::vector<Vec3>& forces) {
  const NodeVectors inner = of_nodes(body, forces) - outer;
  Vec3 place = body.motion.center, spin = Vec3::Zero();
  if (!body.supported()) {
    for (std::size_t i = 0; i < body.nodes.size(); ++i)
      spin += (world.nodes.positions[body.nodes[i]] - place).cross(inner.col(i));
    spin = body.motion.inertia.inverse() * spin;
  } else if (const auto pivot = pivot_of(world, body)) {
    place = pivot->place;
    spin =
        swing_acceleration(*pivot, of_nodes(body, world.nodes.positions), masses_of(world, body), inner, Vec3::Zero());
  }
  for (const NodeId node : body.nodes)
    forces[node] -= world.nodes.masses[node] * spin.cross(world.nodes.positions[node] - place);
}

/// Rotates the forces on a body that swings about a pivot to its orientation in the middle of a substep of `dt` [s].
void turn_forces_halfway(const WorldState& world, const Body& body, double dt, std::vector<Vec3>& forces) {
  const auto pivot = pivot_of(world, body);
  if (!pivot) return;
  const NodeVectors positions = of_nodes(body, world.nodes.positions), acting = of_nodes(body, forces);
  const Vec3 change = acceleration_gained_halfway(*pivot, positions, of_nodes(body, world.nodes.velocities),
                                                  masses_of(world, body), acting, dt);
  for (NodeId node : body.nodes)
    forces[node] += world.nodes.masses[node] * change.cross(world.nodes.positions[node] - pivot->place);
}

/// Takes the `reactions` of the supports of a body, per node [N], from its system after a solve.
void read_back_reactions(const Body& body, std::vector<Vec3>& reactions) {
  const std::span<const NodeId> supports = body.system->supports();
  for (std::size_t i = 0; i < supports.size(); ++i) reactions[supports[i]] = body.system->reaction_forces()[i];
}

SolveReport predict_elastic(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt) {
  const bool has_inner_torque = !body.edges.empty();
  if (body.supported() && !world.integrates_explicitly()) turn_forces_halfway(world, body, dt, forces);
  const NodeVectors outer = has_inner_torque ? of_nodes(body, forces) : NodeVectors();
  add_elastic_forces(world, body, forces, world.scratch);
  for (const EdgeId edge : body.edges) world.scratch.edge_forces[edge] += world.scratch.edge_loads[edge];
  if (has_inner_torque) remove_inner_torque(world, body, outer, forces);
  if (world.integrates_explicitly()) {
    predict_explicitly(world, body, forces, dt);
    return {};
  }
  const SolveReport report =
      body.system->solve(implicit_step(world, body, dt), world.nodes.positions, forces, world.nodes.masses,
                         world.nodes.constraints, world.nodes.velocities,
                         {world.edges.offsets, world.scratch.edge_forces, world.edges.masses, world.edges.velocities});
  read_back_reactions(body, world.nodes.reactions);
  return report;
}

}  // namespace

ImplicitStep implicit_step(const WorldState& world, const Body& body, double dt) {
  constexpr int kFewRows = 64;  // solved accurately at no cost worth saving: debris of soft bodies moves far in a step
  constexpr double kAccurate = 1e-6;
  const Material& material = world.material_of(body);
  const SimulationSettings& settings = world.model->scene.simulation;
  const double residual =
      body.system->rows() <= kFewRows ? std::min(kAccurate, settings.relative_residual) : settings.relative_residual;
  return {dt, material.mass_damping, material.stiffness_damping, residual, settings.max_solver_iterations};
}

namespace {

void update_quadratic_elements(WorldState& world, const Body& body) {
  ElementArrays& elements = world.elements;
  const ElasticLaw law = effective_elastic_law(world, body);
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  const double similarity = body.explicit_state ? body.explicit_state->similarity : 1;
  std::vector<ElementState>& states = elements.states.edit();
  std::vector<QuadraticState>& quadratic = elements.quadratic_states.edit();
  std::vector<Mat3>& stresses = elements.stresses.edit();
  parallel_for(static_cast<int>(body.tets.size()), 512, [&](int begin, int end) {
    for (const TetId tet : std::span(body.tets).subspan(begin, end - begin)) {
      if (plastic) {
        CornerTensors& strains = elements.point_strains[tet];
        strains = flow(*plastic, corner_strains_at(world, law.model, tet), strains);
      }
      const QuadraticStates found = quadratic_states_at(world, law, plastic, tet);
      states[tet] = found.mean;
      states[tet].energy_density *= similarity;
      quadratic[tet] = found.state;
      stresses[tet] = found.mean_cauchy_stress;
    }
  });
}

}  // namespace

void update_elements(WorldState& world, const Body& body) {
  if (!body.edges.empty()) return update_quadratic_elements(world, body);
  ElementArrays& elements = world.elements;
  std::vector<ElementState>& states = elements.states.edit();
  std::vector<Mat3>& stresses = elements.stresses.edit();
  const PlacedElements placed{effective_elastic_law(world, body), world.mesh, elements.rest_elements,
                              world.nodes.positions};
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  const double similarity = body.explicit_state ? body.explicit_state->similarity : 1;
  const auto strain_of = [&](TetId tet, const FourDeformations& deformations, int lane) {
    if (plastic) elements.plastic_strains[tet] = flow(*plastic, deformations.of(lane), elements.plastic_strains[tet]);
    return elements.stress_free_strain(tet);
  };
  const auto write = [&](TetId tet, const FourStates& found, int lane) {
    states[tet] = found.of(lane);
    states[tet].energy_density *= similarity;
    stresses[tet] = found.cauchy_stress.of(lane);
  };
  parallel_for(static_cast<int>(body.tets.size()), 1024, [&](int begin, int end) {
    find_states(placed, std::span(body.tets).subspan(begin, end - begin), strain_of, write);
  });
}

void update_elements(WorldState& world) {
  for (const Body& body : world.bodies)
    if (body.is_deformable()) update_elements(world, body);
}

void assemble_systems(WorldState& world, double dt) {
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      if (world.bodies[i].is_deformable()) assemble_system(world, world.bodies[i], dt);
  });
}

void assemble_system(const WorldState& world, Body& body, double dt) {
  if (world.integrates_explicitly()) return;
  body.system->assemble(implicit_step(world, body, dt), elastic_law(world.material_of(body)),
                        world.elements.rest_elements, world.elements.states, world.nodes.positions, world.nodes.masses,
                        world.edges.masses);
}

namespace {

void count_solve(const SolveReport& solve, StepReport& report) {
  report.solver_iterations = std::max(report.solver_iterations, solve.iterations);
  report.max_relative_residual = std::max(report.max_relative_residual, solve.relative_residual);
  report.unconverged_solves += !solve.converged;
}

}  // namespace

void predict_velocities(WorldState& world, Body& body, std::vector<Vec3> forces, double dt) {
  count_solve(predict_elastic(world, body, forces, dt), world.report);
}

void predict_velocities(WorldState& world, std::vector<Vec3> forces, double dt) {
  world.scratch.elastic_forces.resize(world.nodes.positions.size());
  world.scratch.edge_forces.resize(world.edges.offsets.size());
  std::vector<SolveReport> reports(world.bodies.size());
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Body& body = world.bodies[i];
      if (body.asleep) continue;
      for (const NodeId node : body.nodes) world.nodes.reactions[node].setZero();
      if (body.explicit_state) continue;
      BodyStep& step = world.scratch.bodies[body.id];
      if (body.rigid) {
        predict_rigid(world, body, forces, dt, step.start);
      } else {
        step.energy = mechanical_energy(world, body);
        step.contact_work = 0;
        reports[i] = predict_elastic(world, body, forces, dt);
      }
    }
  });
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    freeze_if_broken_down(world, world.bodies[i]);
    count_solve(reports[i], world.report);
  }
}

}  // namespace griffith
