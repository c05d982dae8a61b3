#include "sim/world/motion/equilibrium.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/elasticity/plasticity.h"
#include "sim/solver/static_solve.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/element_states.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Flow of a body from the plastic strains of the world, which stay those of the start until the solve has ended. What
/// the stress derives from is the elastic energy plus the work at the yield strength (Simo & Hughes 1998).
class TrialFlow {
 public:
  TrialFlow(const WorldState& world, const Body& body)
      : elements_(world.elements),
        plastic_(plastic_law(world.material_of(body))),
        shear_modulus_(griffith::shear_modulus(world.material_of(body))) {}

  const std::optional<PlasticLaw>& law() const { return plastic_; }
  /// Returns the stress-free strain of a linear tet, and sets the work [J/m³].
  Mat3 of_tet(TetId tet, const ElementDeformation& deformation, double& work) const {
    const Mat3 before = elements_.plastic_strain(tet);
    const Mat3 after = plastic_ ? flow(*plastic_, deformation, before) : before;
    work = plastic_ ? yield_work(*plastic_, shear_modulus_, after - before) : 0;
    return after;
  }
  /// Returns those of the corners of a quadratic tet, and sets the work [J/m³].
  CornerTensors of_corners(TetId tet, const CornerStrains& strains, double& work) const {
    work = 0;
    CornerTensors free = elements_.corner_stress_free_strains(tet);
    if (!plastic_) return free;
    const CornerTensors& before = elements_.point_strains[tet];
    CornerTensors flowed = flow(*plastic_, strains, before);
    for (int i = 0; i < 4; ++i) {
      flowed[i] -= before[i];
      work += yield_work(*plastic_, shear_modulus_, flowed[i]) / 4;
    }
    const CornerTensors added = at_corners(flowed);
    for (int v = 0; v < 4; ++v) free[v] += added[v];
    return free;
  }

 private:
  const ElementArrays& elements_;
  std::optional<PlasticLaw> plastic_;
  double shear_modulus_;
};

/// Adds a quadratic body's edges to a problem, which sets their offsets in the world.
void add_edges(WorldState& world, const Body& body, std::span<const Vec3> loads, StaticProblem& problem) {
  std::vector<QuadraticState>& quadratic = world.elements.quadratic_states.edit();
  problem.edges.emplace(StaticEdges{world.tet_edges, world.edges.offsets, quadratic, loads});
  problem.evaluate = [&world, &body, &quadratic, law = problem.law, flow = TrialFlow(world, body)](
                         std::span<const Vec3> positions, std::span<ElementState> states) {
    parallel_for(static_cast<int>(body.tets.size()), 512, [&](int begin, int end) {
      for (const TetId tet : std::span(body.tets).subspan(begin, end - begin)) {
        const RestElement& rest = world.elements.rest_elements[tet];
        const Corners corners = corners_of(world.mesh, tet, positions);
        const EdgeVectors offsets = edges_of(world.tet_edges, tet, world.edges.offsets);
        const CornerStrains strains = flow.law() ? corner_strains(law.model, rest, corners, offsets) : CornerStrains();
        double work;
        const CornerTensors free = flow.of_corners(tet, strains, work);
        const QuadraticStates found = quadratic_states(law, rest, corners, offsets, free, flow.law());
        states[tet] = found.mean;
        states[tet].energy_density += work;
        quadratic[tet] = found.state;
      }
    });
  };
}

StaticProblem problem_of(WorldState& world, const Body& body, std::span<const NodeConstraint> displacements,
                         const ExternalForces& loads, std::span<const PressedFace> pressed) {
  const ElasticLaw law = elastic_law(world.material_of(body));
  const auto evaluate = [&world, &body, law, flow = TrialFlow(world, body)](std::span<const Vec3> positions,
                                                                            std::span<ElementState> states) {
    const PlacedElements placed{law, world.mesh, world.elements.rest_elements, positions};
    std::vector<double> works(world.elements.states.size());
    parallel_for(static_cast<int>(body.tets.size()), 1024, [&](int begin, int end) {
      find_states(
          placed, std::span(body.tets).subspan(begin, end - begin),
          [&](TetId tet, const FourDeformations& deformations, int lane) {
            return flow.of_tet(tet, deformations.of(lane), works[tet]);
          },
          [&](TetId tet, const FourStates& found, int lane) {
            states[tet] = found.of(lane);
            states[tet].energy_density += works[tet];
          });
    });
  };
  StaticProblem problem{world.mesh,  body.tets, world.elements.rest_elements, law, world.nodes.masses, displacements,
                        loads.nodes, evaluate};
  problem.has_stress_free_strains = !world.elements.plastic_strains.empty();
  if (!body.edges.empty()) add_edges(world, body, loads.edges, problem);
  if (!pressed.empty())
    problem.add_follower_loads = [pressed](std::span<const Vec3> positions, std::span<Vec3> forces,
                                           std::span<Vec3> of_edges) {
      add_pressure(pressed, positions, forces, of_edges);
    };
  return problem;
}

/// Returns false if the solve did not converge. The tangent is elastic, so where a body yields each step takes a part
/// of the imbalance only.
bool settle(WorldState& world, Body& body, const StaticProblem& problem, const Monitor& monitor) {
  StaticSettings settings;
  if (world.material_of(body).yield_strength) settings.relative_residual = 1e-6, settings.max_newton_steps = 500;
  settings.cancelled = monitor.cancelled;
  const StaticReport report = solve_static(problem, settings, world.nodes.positions, world.elements.states.edit());
  if (monitor.is_cancelled()) throw Cancelled();
  for (NodeId node : body.nodes) world.nodes.velocities[node] = world.nodes.reactions[node] = Vec3::Zero();
  for (EdgeId edge : body.edges) world.edges.velocities[edge].setZero();
  for (std::size_t i = 0; i < report.supports.size(); ++i)
    world.nodes.reactions[report.supports[i]] = report.reaction_forces[i];
  update_motion(world, body);
  world.report.solver_iterations = std::max(world.report.solver_iterations, report.linear_iterations);
  world.report.max_relative_residual = std::max(world.report.max_relative_residual, report.relative_residual);
  world.report.unconverged_solves += !report.converged;
  return report.converged;
}

/// True if a body has no equilibrium near its place: one that hangs by a node, or that has buckled.
bool has_run_away(const WorldState& world, const Body& body, const BodySnapshot& before) {
  constexpr double kFar = 100;  // extents
  const double far = kFar * body.extent;
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    if (!((world.nodes.positions[body.nodes[i]] - before.positions[i]).norm() < far)) return true;
  return std::ranges::any_of(body.edges, [&](EdgeId edge) { return !(world.edges.offsets[edge].norm() < far); });
}

/// Puts a body without equilibrium back; its solve counts as unconverged.
void put_back(WorldState& world, Body& body, const BodySnapshot& before) {
  for (std::size_t i = 0; i < body.nodes.size(); ++i) world.nodes.positions[body.nodes[i]] = before.positions[i];
  for (std::size_t i = 0; i < body.edges.size(); ++i) world.edges.offsets[body.edges[i]] = before.offsets[i];
  update_motion(world, body);
  update_elements(world, body);
}

/// Nodes of a body that lie on the ground in equilibrium, without friction: those that would sink into it otherwise.
/// Nodes that start below the ground are part of a foundation.
class GroundedNodes {
 public:
  GroundedNodes(const WorldState& world, const Body& body, const BodySnapshot& before)
      : body_(body), before_(before), is_on_ground_(body.nodes.size(), false) {
    constexpr double kTouching = 1e-9;  // of the extent
    if (const auto& ground = world.model->scene.ground) height_ = ground->height;
    tolerance_ = kTouching * body.extent;
  }

  /// Updates the nodes after a solve: those below the ground join, those that it would have to pull leave. False if
  /// nothing changes.
  bool update(WorldState& world) {
    bool changed = false;
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      const NodeId node = body_.nodes[i];
      const bool sinks = before_.positions[i].y() >= height_ - tolerance_ &&
                         world.nodes.positions[node].y() < height_ - tolerance_ &&
                         world.nodes.constraints[node].allowed(1, 1) > 0.5;
      const bool lies = is_on_ground_[i] ? world.nodes.reactions[node].y() >= 0 : sinks;
      changed = changed || lies != is_on_ground_[i];
      is_on_ground_[i] = lies;
    }
    return changed;
  }

  /// Lets nodes on the ground move down to it and no further.
  void block(std::vector<NodeConstraint>& displacements) const {
    for (std::size_t i = 0; i < body_.nodes.size(); ++i)
      if (is_on_ground_[i]) displacements[body_.nodes[i]].block(Vec3::UnitY(), height_ - before_.positions[i].y());
  }

  /// Removes the ground's forces from the reactions of supports.
  void leave_reactions(WorldState& world) const {
    for (std::size_t i = 0; i < body_.nodes.size(); ++i)
      if (is_on_ground_[i]) world.nodes.reactions[body_.nodes[i]].y() = 0;
  }

 private:
  const Body& body_;
  const BodySnapshot& before_;
  std::vector<bool> is_on_ground_;
  double height_ = -std::numeric_limits<double>::infinity(), tolerance_ = 0;
};

bool has_residual_stress(const WorldState& world, const Body& body) {
  return world.model->scene.bodies[body.scene_body].residual_stress.has_value();
}

/// True if a body does not start at rest: its scene gives it a velocity, or nothing supports it.
bool starts_in_motion(const WorldState& world, const Body& body) {
  const BodyDescription& described = world.model->scene.bodies[body.scene_body];
  return !body.supported() || !described.velocity.isZero(0) || !described.angular_velocity.isZero(0);
}

/// Gives a body in equilibrium back the velocities that it starts with.
void start_in_motion(WorldState& world, Body& body, const std::vector<Vec3>& velocities,
                     const std::vector<Vec3>& of_edges) {
  for (const NodeId node : body.nodes) world.nodes.velocities[node] = velocities[node];
  for (const EdgeId edge : body.edges) world.edges.velocities[edge] = of_edges[edge];
  update_motion(world, body);
}

}  // namespace

void find_equilibrium(WorldState& world, double time, double displacement_time,
                      const std::function<bool(const Body&)>& concerns, const Monitor& monitor) {
  constexpr int kMostSolves = 30;
  std::vector<NodeConstraint> displacements = world.nodes.constraints;
  for (NodeConstraint& constraint : displacements) constraint.velocity *= displacement_time;
  ExternalForces loads = weights(world);
  add_dead_forces(world, time, loads);
  const std::vector<std::vector<PressedFace>> pressed = pressed_faces(world, time);
  for (Body& body : world.bodies) {
    if (body.rigid || !concerns(body)) continue;
    const BodySnapshot before = snapshot(world, body);
    const std::vector<Mat3> stresses = stresses_of(world, body);
    bool settled = settle(world, body, problem_of(world, body, displacements, loads, pressed[body.id]), monitor);
    GroundedNodes grounded(world, body, before);
    for (int solve = 1; settled && body.supported() && grounded.update(world); ++solve) {
      put_back(world, body, before);
      std::vector<NodeConstraint> above = displacements;
      grounded.block(above);
      settled =
          solve < kMostSolves && settle(world, body, problem_of(world, body, above, loads, pressed[body.id]), monitor);
      if (solve == kMostSolves) ++world.report.unconverged_solves;
    }
    grounded.leave_reactions(world);
    if (has_run_away(world, body, before)) put_back(world, body, before);
    if (world.material_of(body).yield_strength) update_elements(world, body);
    world.energy += spent_in_equilibrium(world, body, before, stresses, displacement_time);
    freeze_if_broken_down(world, body);
  }
}

void find_static_start(WorldState& world, int scene_body, const Monitor& monitor) {
  if (!world.model->scene.simulation.static_start || world.model->scene.analysis != Analysis::dynamic) return;
  const auto concerns = [&](const Body& body) {
    return (body.supported() || has_residual_stress(world, body)) && (scene_body < 0 || body.scene_body == scene_body);
  };
  const std::vector<Vec3> velocities = world.nodes.velocities, of_edges = world.edges.velocities;
  find_equilibrium(world, 0, 0, concerns, monitor);
  for (Body& body : world.bodies)
    if (concerns(body) && starts_in_motion(world, body)) start_in_motion(world, body, velocities, of_edges);
}

}  // namespace griffith
