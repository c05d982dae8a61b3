#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/elasticity/plasticity.h"
#include "sim/mesh/topology.h"
#include "sim/parallel.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

void update_element(WorldState& world, const ElasticLaw& law, const std::optional<PlasticLaw>& plastic, TetId tet) {
  ElementArrays& elements = world.elements;
  const ElementDeformation deformation =
      element_deformation(law.model, elements.rests[tet], corners_of(world.mesh, tet, world.nodes.positions));
  if (plastic) elements.plastic_strains[tet] = flow(*plastic, deformation, elements.plastic_strains[tet]);
  elements.states[tet] = element_state(law, deformation, elements.plastic_strains[tet]);
  elements.stresses[tet] = cauchy_stress(elements.states[tet].frame, elements.states[tet].stress);
}

void update_elements(WorldState& world, const Body& body) {
  const ElasticLaw law = elastic_law(world.material_of(body));
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  parallel_for(static_cast<int>(body.tets.size()), 1024, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) update_element(world, law, plastic, body.tets[i]);
  });
}

/// Elastic plus external force of the body's nodes, per node of the mesh; only the body's own entries are written.
void add_elastic_forces(const WorldState& world, const Body& body, std::vector<Vec3>& forces) {
  const ElementArrays& elements = world.elements;
  parallel_for(static_cast<int>(body.nodes.size()), 1024, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const NodeId node = body.nodes[i];
      for (TetId tet : world.mesh.stars[node]) {
        const int corner = local_corner(world.mesh, tet, node);
        const Vec3 traction = elements.states[tet].stress * elements.rests[tet].shape_gradients.col(corner);
        forces[node] -= elements.rests[tet].volume * (elements.states[tet].frame * traction);
      }
    }
  });
}

/// Moves a free body by its velocities: its rigid part turns it, what is left deforms it. Along the tangents instead, a
/// turn by the angle a would stretch it by a²/2, which a stiff body answers with more than its strength. Linear and
/// angular momentum are kept.
void move_free(WorldState& world, Body& body, double dt) {
  body.motion = motion_of(world, body);
  const RigidMotion before = body.motion;
  const Mat3 turn = turn_step(before, dt);
  const Vec3 center = before.center + dt * before.velocity;
  for (NodeId node : body.nodes) {
    Vec3 &position = world.nodes.positions[node], &velocity = world.nodes.velocities[node];
    const Vec3 deforming = velocity - before.velocity_at(position);
    position = center + turn * (position - before.center + dt * deforming);
    velocity = turn * deforming;
  }
  const RigidMotion after = motion_of(world, body);
  const Vec3 spin = after.inertia.inverse() * (before.inertia * before.angular_velocity);
  for (NodeId node : body.nodes)
    world.nodes.velocities[node] += before.velocity + spin.cross(world.nodes.positions[node] - center);
}

/// The rigid motion under the external forces; the shape stays as it is.
void predict_rigid(WorldState& world, Body& body, const std::vector<Vec3>& forces, double dt) {
  if (body.supported()) return;  // frozen by freeze(): its supports hold it
  const double damping = 1 + dt * world.material_of(body).mass_damping;
  for (NodeId node : body.nodes)
    world.nodes.velocities[node] =
        (world.nodes.velocities[node] + dt / world.nodes.masses[node] * forces[node]) / damping;
  const RigidMotion motion = motion_of(world, body);
  for (NodeId node : body.nodes)
    world.nodes.velocities[node] = motion.velocity_at(world.nodes.positions[node]);
}

bool all_finite(const WorldState& world, const Body& body) {
  return std::all_of(body.nodes.begin(), body.nodes.end(),
                     [&](NodeId node) { return world.nodes.velocities[node].allFinite(); });
}

/// A body whose numbers broke down stays where it is, rigid and at rest: one lost body, not a lost scene.
void freeze(WorldState& world, Body& body) {
  for (NodeId node : body.nodes) world.nodes.velocities[node].setZero();
  body.rigid = true;
  ++world.report.non_finite_values;
}

SolveReport predict_elastic(WorldState& world, Body& body, std::vector<Vec3>& forces, double dt) {
  add_elastic_forces(world, body, forces);
  if (world.integrates_explicitly()) {
    predict_explicitly(world, body, forces, dt);
    return {};
  }
  const SolveReport report = body.system->solve(implicit_step(world, body, dt), world.nodes.positions, forces,
                                                world.nodes.masses, world.nodes.constraints, world.nodes.velocities);
  for (std::size_t i = 0; i < body.system->supports().size(); ++i)
    world.nodes.reactions[body.system->supports()[i]] = body.system->reaction_forces()[i];
  return report;
}

void move_body(WorldState& world, Body& body, double dt) {
  const bool turns = !body.supported() && (body.rigid || !world.integrates_explicitly());
  if (turns) return move_free(world, body, dt);
  for (NodeId node : body.nodes) world.nodes.positions[node] += dt * world.nodes.velocities[node];
}

}  // namespace

ImplicitStep implicit_step(const WorldState& world, const Body& body, double dt) {
  const Material& material = world.material_of(body);
  const SimulationSettings& settings = world.scene.simulation;
  return {dt, material.mass_damping, material.stiffness_damping, settings.relative_residual,
          settings.max_solver_iterations};
}

void update_elements(WorldState& world) {
  for (const Body& body : world.bodies) {
    if (body.rigid) continue;
    update_elements(world, body);
    for (TetId tet : body.tets) world.report.inverted_tets += world.elements.states[tet].inverted;
  }
}

void wake(WorldState& world, Body& body) {
  body.rigid = false;
  body.calm_steps = 0;
  update_elements(world, body);  // it has turned since
}

void assemble_systems(WorldState& world, double dt) {
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      if (!world.bodies[i].rigid) assemble_system(world, world.bodies[i], dt);
  });
}

void assemble_system(WorldState& world, Body& body, double dt) {
  if (world.integrates_explicitly()) return;
  body.system->assemble(implicit_step(world, body, dt), elastic_law(world.material_of(body)), world.elements.rests,
                        world.elements.states, world.nodes.positions, world.nodes.masses);
}

void count_solve(WorldState& world, const SolveReport& solve) {
  world.report.solver_iterations = std::max(world.report.solver_iterations, solve.iterations);
  world.report.max_relative_residual = std::max(world.report.max_relative_residual, solve.relative_residual);
  world.report.unconverged_solves += !solve.converged;
}

void predict_velocities(WorldState& world, std::vector<Vec3>& forces, double dt) {
  std::vector<SolveReport> reports(world.bodies.size());
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Body& body = world.bodies[i];
      if (body.rigid) {
        predict_rigid(world, body, forces, dt);
      } else {
        reports[i] = predict_elastic(world, body, forces, dt);
      }
    }
  });
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!all_finite(world, world.bodies[i])) freeze(world, world.bodies[i]);
    count_solve(world, reports[i]);
  }
}

void move_bodies(WorldState& world, double dt) {
  parallel_for(static_cast<int>(world.bodies.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) move_body(world, world.bodies[i], dt);
  });
  for (Body& body : world.bodies) {
    if (!all_finite(world, body)) freeze(world, body);
    update_motion(world, body);
  }
  place_stand_ins(world);
}

void calm_bodies(WorldState& world) {
  constexpr double kCalmMargin = 0.05;
  constexpr int kCalmSteps = 20;
  for (Body& body : world.bodies) {
    if (body.rigid || body.supported()) continue;
    const bool calm = std::all_of(body.nodes.begin(), body.nodes.end(), [&](NodeId node) {
      return world.nodes.separations[node].margin < kCalmMargin;
    });
    body.calm_steps = calm ? body.calm_steps + 1 : 0;
    body.rigid = body.calm_steps >= kCalmSteps;
  }
}

}  // namespace griffith
