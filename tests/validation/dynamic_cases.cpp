#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/core/dense_algebra.h"
#include "sim/solver/explicit_step.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"
#include "tests/validation/specimen.h"

namespace griffith::validation {
namespace {

std::string formatted(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The stiffness of a specimen's body in its present state, one row a node that is not held.
struct LinearSystem {
  ElasticSystem& system;
  Eigen::MatrixXd stiffness;  // rows and columns by node, then axis [N/m]
  Eigen::VectorXd masses;     // per row of the system [kg]
};

LinearSystem linear_system(Specimen& specimen) {
  WorldState& world = specimen.world();
  ElasticSystem& system = *world.bodies[0].system;
  system.assemble(MatrixFactors{0, 1}, elastic_law(world.materials[0]), world.elements.rest_elements,
                  world.elements.states, world.nodes.positions, world.nodes.masses);
  const BlockSparseMatrix& blocks = system.matrix();
  LinearSystem linear{system, Eigen::MatrixXd::Zero(3 * blocks.rows(), 3 * blocks.rows()), {}};
  for (int row = 0; row < blocks.rows(); ++row)
    for (int slot = blocks.row_starts[row]; slot < blocks.row_starts[row + 1]; ++slot)
      linear.stiffness.block<3, 3>(3 * row, 3 * blocks.columns[slot]) = blocks.blocks[slot];
  linear.masses.resize(blocks.rows());
  for (int row = 0; row < blocks.rows(); ++row) linear.masses[row] = world.nodes.masses[system.nodes()[row]];
  return linear;
}

/// Natural frequencies [rad/s], ascending, and mass-normalised modes: one column a mode, three rows a node.
struct Modes {
  Eigen::VectorXd frequencies;
  Eigen::MatrixXd shapes;
};

Modes modes_of(const LinearSystem& linear) {
  const Eigen::VectorXd roots = linear.masses.cwiseSqrt().cwiseInverse();
  Eigen::VectorXd scale(3 * roots.size());
  for (int i = 0; i < scale.size(); ++i) scale[i] = roots[i / 3];
  const SymmetricModes modes = symmetric_modes(scale.asDiagonal() * linear.stiffness * scale.asDiagonal());
  return {modes.values.cwiseMax(0).cwiseSqrt(), scale.asDiagonal() * modes.vectors};
}

/// Displacements and velocities of the rows of a linear system, as vectors.
struct Motion {
  Eigen::VectorXd displacement, velocity;
};

double energy(const LinearSystem& linear, const Motion& motion) {
  double sum = motion.displacement.dot(linear.stiffness * motion.displacement) / 2;
  for (int i = 0; i < motion.velocity.size(); ++i)
    sum += linear.masses[i / 3] * motion.velocity[i] * motion.velocity[i] / 2;
  return sum;
}

/// f = −K u per node of the mesh [N].
std::vector<Vec3> linear_forces(const LinearSystem& linear, const Motion& motion, int nodes) {
  const Eigen::VectorXd force = -linear.stiffness * motion.displacement;
  std::vector<Vec3> forces(nodes, Vec3::Zero());
  for (std::size_t row = 0; row < linear.system.nodes().size(); ++row)
    forces[linear.system.nodes()[row]] = force.segment<3>(3 * static_cast<int>(row));
  return forces;
}

/// One implicit step of the linear system by the solver itself.
void step_implicitly(Specimen& specimen, LinearSystem& linear, const ImplicitStep& step, Motion& motion) {
  WorldState& world = specimen.world();
  std::vector<Vec3> velocities(specimen.node_count(), Vec3::Zero());
  const std::span<const NodeId> nodes = linear.system.nodes();
  for (std::size_t row = 0; row < nodes.size(); ++row)
    velocities[nodes[row]] = motion.velocity.segment<3>(3 * static_cast<int>(row));
  linear.system.assemble(step, elastic_law(world.materials[0]), world.elements.rest_elements, world.elements.states,
                         world.nodes.positions, world.nodes.masses);
  linear.system.solve(step, world.nodes.positions, linear_forces(linear, motion, specimen.node_count()),
                      world.nodes.masses, world.nodes.constraints, velocities);
  for (std::size_t row = 0; row < nodes.size(); ++row)
    motion.velocity.segment<3>(3 * static_cast<int>(row)) = velocities[nodes[row]];
  motion.displacement += step.dt * motion.velocity;
}

/// Symplectic Euler for the linear system: the energy's largest growth in so many steps.
double explicit_growth(const LinearSystem& linear, double dt, Motion motion, int steps) {
  const double start = energy(linear, motion);
  double largest = 1;
  for (int i = 0; i < steps && largest < 1e9; ++i) {
    const Eigen::VectorXd force = -linear.stiffness * motion.displacement;
    for (int k = 0; k < force.size(); ++k) motion.velocity[k] += dt * force[k] / linear.masses[k / 3];
    motion.displacement += dt * motion.velocity;
    largest = std::max(largest, energy(linear, motion) / start);
  }
  return largest;
}

/// The stable explicit step of a body at rest [s].
double stable_step(Specimen& specimen) {
  WorldState& world = specimen.world();
  ElasticSystem& system = *world.bodies[0].system;
  system.assemble(MatrixFactors{0, 1}, elastic_law(world.materials[0]), world.elements.rest_elements,
                  world.elements.states, world.nodes.positions, world.nodes.masses);
  Eigen::VectorXd masses(system.matrix().rows());
  for (int row = 0; row < masses.size(); ++row) masses[row] = world.nodes.masses[system.nodes()[row]];
  return stable_time_step(highest_frequency(system.matrix(), masses));
}

/// A step of the body under constant external forces.
void step_explicitly(Specimen& specimen, double dt, const std::vector<Vec3>& external) {
  WorldState& world = specimen.world();
  std::vector<Vec3> forces = specimen.elastic_forces();
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] += external[i];
  explicit_step(dt, 0, world.bodies[0].nodes, world.nodes.constraints, world.nodes.masses, forces,
                world.nodes.velocities);
  for (NodeId node : world.bodies[0].nodes) world.nodes.positions[node] += dt * world.nodes.velocities[node];
  update_elements(world);
}

/// A step of the body without external forces, as the world makes it.
void step_implicitly(Specimen& specimen, double dt) {
  WorldState& world = specimen.world();
  std::vector<Vec3> forces(specimen.node_count(), Vec3::Zero());
  record_substep_start(world, world.scratch);
  assemble_systems(world, dt);
  predict_velocities(world, forces, dt);
  move_bodies(world, forces, std::vector<ElasticMove>(world.bodies.size()), dt);
}

struct Balance {
  double energy = 0;  // kinetic and elastic [J]
  Vec3 momentum = Vec3::Zero(), angular_momentum = Vec3::Zero();
};

Balance balance_of(Specimen& specimen) {
  const WorldState& world = specimen.world();
  Balance balance;
  for (std::size_t i = 0; i < world.nodes.positions.size(); ++i) {
    const Vec3 momentum = world.nodes.masses[i] * world.nodes.velocities[i];
    balance.energy += momentum.dot(world.nodes.velocities[i]) / 2;
    balance.momentum += momentum;
    balance.angular_momentum += world.nodes.positions[i].cross(momentum);
  }
  for (std::size_t i = 0; i < world.elements.rest_elements.size(); ++i)
    balance.energy += world.elements.rest_elements[i].volume * world.elements.states[i].energy_density;
  return balance;
}

/// Returns the relative change of momenta.
double momentum_error(const Balance& now, const Balance& start) {
  return std::max((now.momentum - start.momentum).norm() / start.momentum.norm(),
                  (now.angular_momentum - start.angular_momentum).norm() / start.angular_momentum.norm());
}

/// A turning, flying block, let go stretched by some tenths of a percent.
Scene spinning_block(BoxPattern pattern) {
  Scene scene = validation_scene("spinning_block");
  std::get<BoxShape>(scene.bodies[0].shape).pattern = pattern;
  return scene;
}

Vec3 stretched(const Vec3& x) { return Vec3(1.004, 0.998, 1.002).cwiseProduct(x); }

/// Energy drift, energy swing and momentum error of 10,000 explicit steps.
std::vector<Row> explicit_run(BoxPattern pattern) {
  constexpr int kSteps = 10'000, kWindow = 1'000;
  Specimen specimen(spinning_block(pattern));
  const double dt = stable_step(specimen) / 2;
  specimen.deform(stretched);
  const Balance start = balance_of(specimen);
  const std::vector<Vec3> no_forces(specimen.node_count(), Vec3::Zero());
  double first = 0, last = 0, swing = 0, momentum = 0;
  for (int step = 0; step < kSteps; ++step) {
    step_explicitly(specimen, dt, no_forces);
    const Balance now = balance_of(specimen);
    if (step < kWindow) first += now.energy / kWindow;
    if (step >= kSteps - kWindow) last += now.energy / kWindow;
    swing = std::max(swing, std::abs(now.energy / start.energy - 1));
    momentum = std::max(momentum, momentum_error(now, start));
  }
  const MeshLabel mesh = mesh_label(pattern, 2);
  return {at_most(mesh, "explicit: drift of the mean energy", 1e-3, std::abs(last / first - 1)),
          at_most(mesh, "explicit: largest swing of the energy", 0.1, swing),
          at_most(mesh, "explicit: momentum and angular momentum", 1e-10, momentum)};
}

/// Largest gain of energy in one of 1,000 implicit steps, energy left at the end, and momentum error.
std::vector<Row> implicit_run(BoxPattern pattern) {
  constexpr int kSteps = 1'000;
  const Scene scene = spinning_block(pattern);
  Specimen specimen(scene);
  specimen.deform(stretched);
  const Balance start = balance_of(specimen);
  double before = start.energy, gain = 0, momentum = 0;
  for (int step = 0; step < kSteps; ++step) {
    step_implicitly(specimen, scene.simulation.time_step);
    const Balance now = balance_of(specimen);
    gain = std::max(gain, (now.energy - before) / start.energy);
    momentum = std::max(momentum, momentum_error(now, start));
    before = now.energy;
  }
  const MeshLabel mesh = mesh_label(pattern, 2);
  return {at_most(mesh, "implicit: largest gain of energy in a step", 1e-8, gain),
          at_most(mesh, "implicit: energy at the end / at the start", 1, before / start.energy),
          at_most(mesh, "implicit: momentum and angular momentum", 1e-10, momentum)};
}

/// A bar two cells across and `cells` long, pushed at its left end.
Scene pushed_bar(BoxPattern pattern, int cells) {
  Scene scene = validation_scene("bar_wave");
  auto& box = std::get<BoxShape>(scene.bodies[0].shape);
  const double edge = box.size.x() / cells;
  box.pattern = pattern;
  box.size = Vec3(box.size.x(), 2 * edge, 2 * edge);
  box.element_size = Vec3::Constant(edge);
  return scene;
}

/// When the free end reaches a tenth of its final velocity, 2σ/(ρc), over L/c.
double arrival(const Scene& scene) {
  constexpr double kLevel = 0.1;
  const double length = std::get<BoxShape>(scene.bodies[0].shape).size.x();
  const Material& material = scene.bodies[0].material;
  const double speed = bar_wave_speed(material);
  const double final_velocity = 2 * scene.bodies[0].loads[0].traction.norm() / (material.density * speed);
  Specimen specimen(scene);
  const double dt = stable_step(specimen);
  const std::vector<int> end = specimen.nodes_where([&](const Vec3& x) { return x.x() > length / 2 - 1e-9; });
  ExternalForces forces = no_forces(specimen.world());
  add_load_forces(specimen.world(), 0, forces);
  double before = 0;
  for (int step = 1; step * dt < 2 * length / speed; ++step) {
    step_explicitly(specimen, dt, forces.nodes);
    double now = 0;
    for (int node : end) now += specimen.world().nodes.velocities[node].x() / static_cast<double>(end.size());
    if (now >= kLevel * final_velocity)
      return (step - (now - kLevel * final_velocity) / (now - before)) * dt * speed / length;
    before = now;
  }
  return 2;
}

}  // namespace

std::vector<Row> longitudinal_wave(Extent extent) {
  // The finest bar takes four times as long as the others together.
  const std::vector<int> meshes = extent == Extent::test ? std::vector{50, 100, 200} : std::vector{100, 200, 400};
  const double finest_arrival = extent == Extent::test ? 0.987 : 0.992;
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    double coarser = 0;
    for (int cells : meshes) {
      const double time = arrival(pushed_bar(pattern, cells));
      rows.push_back(at_least(mesh_label(pattern, cells), "arrival; that at n/2", coarser, time));
      rows.push_back(at_most(mesh_label(pattern, cells), "arrival; an ideal wave's", 1, time));
      coarser = time;
    }
    if (pattern == BoxPattern::bcc) continue;
    rows.push_back(near(mesh_label(pattern, meshes.back()), "arrival", finest_arrival, coarser, 0.002));
  }
  return rows;
}

std::vector<Row> free_fall(Extent) {
  constexpr int kSteps = 120;
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    double error = 0, strain = 0;
    for (double young_modulus : {1e4, 1e6, 1e8, 1e10, 4e11}) {
      Scene scene = validation_scene("free_fall");
      BodyDescription& body = scene.bodies[0];
      body.material.young_modulus = young_modulus;
      std::get<BoxShape>(body.shape).pattern = pattern;
      World world(scene);
      const double h = scene.simulation.time_step;
      for (int i = 1; i <= kSteps; ++i) {
        world.step();
        const Frame frame = world.frame();
        const double t = i * h;
        const Vec3 path = t * body.velocity + t * (t + h) / 2 * scene.gravity;
        for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node)
          error = std::max(
              error, (frame.nodes.positions[node] - frame.nodes.rest_positions[node] - path).norm() / path.norm());
        for (const Mat3& stress : frame.elements.stresses) strain = std::max(strain, stress.norm() / young_modulus);
      }
    }
    rows.push_back(at_most(mesh_label(pattern, 4), "path, worst node, step and E", 1e-12, error));
    rows.push_back(at_most(mesh_label(pattern, 4), "stress / E, worst tet, step and E", 1e-12, strain));
  }
  return rows;
}

std::vector<Row> mode_decay(Extent) {
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    Scene scene = validation_scene("held_block");
    std::get<BoxShape>(scene.bodies[0].shape).pattern = pattern;
    Specimen specimen(scene);
    LinearSystem linear = linear_system(specimen);
    const Modes modes = modes_of(linear);
    const int last = static_cast<int>(modes.frequencies.size()) - 1;
    const MeshLabel mesh = mesh_label(pattern, 2);
    for (int mode : {0, last / 2, last}) {
      const double omega = modes.frequencies[mode];
      const ImplicitStep step{
          .dt = 1 / modes.frequencies[last / 2], .relative_residual = 1e-14, .max_iterations = 2000};
      Motion motion{1e-3 * modes.shapes.col(mode), 1e-3 * omega * modes.shapes.col(mode)};
      const double start = energy(linear, motion);
      constexpr int kSteps = 5;
      for (int i = 0; i < kSteps; ++i) step_implicitly(specimen, linear, step, motion);
      const double decay = std::pow(1 + std::pow(omega * step.dt, 2), -kSteps);
      rows.push_back(at_most(mesh, formatted("energy after 5 steps · (1+ω²h²)⁵, error, ωh = %.3g", omega * step.dt),
                             1e-10, std::abs(energy(linear, motion) / start / decay - 1)));
    }
    linear_system(specimen);  // leaves the stiffness alone in the system's matrix
    const double estimate = highest_frequency(linear.system.matrix(), linear.masses);
    rows.push_back(near(mesh, "highest frequency, Lanczos / eigenvalue", 1, estimate / modes.frequencies[last], 0.01));
    const Motion start{modes.shapes * Eigen::VectorXd::Ones(last + 1), Eigen::VectorXd::Zero(last + 1)};
    rows.push_back(at_most(mesh, "explicit, stable step: energy's growth in 10,000 steps", 19,
                           explicit_growth(linear, stable_time_step(estimate), start, 10000)));
    rows.push_back(at_least(mesh, "explicit, 1.01 · 2/ω: energy's growth", 1e9,
                            explicit_growth(linear, 1.01 * 2 / modes.frequencies[last], start, 10000)));
  }
  return rows;
}

std::vector<Row> long_run(Extent) {
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    for (const Row& row : explicit_run(pattern)) rows.push_back(row);
    for (const Row& row : implicit_run(pattern)) rows.push_back(row);
  }
  return rows;
}

}  // namespace griffith::validation
