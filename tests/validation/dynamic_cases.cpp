#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/solver/explicit_step.h"
#include "sim/world/phases.h"
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
  system.assemble(MatrixFactors{0, 1}, elastic_law(world.materials[0]), world.elements.rests, world.elements.states,
                  world.nodes.positions, world.nodes.masses);
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
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * linear.stiffness * scale.asDiagonal());
  return {eigen.eigenvalues().cwiseMax(0).cwiseSqrt(), scale.asDiagonal() * eigen.eigenvectors()};
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
  linear.system.assemble(step, elastic_law(world.materials[0]), world.elements.rests, world.elements.states,
                         world.nodes.positions, world.nodes.masses);
  linear.system.solve(step, world.nodes.positions, linear_forces(linear, motion, specimen.node_count()),
                      world.nodes.masses, world.nodes.constraints, velocities);
  for (std::size_t row = 0; row < nodes.size(); ++row)
    motion.velocity.segment<3>(3 * static_cast<int>(row)) = velocities[nodes[row]];
  motion.displacement += step.dt * motion.velocity;
}

/// Symplectic Euler for the linear system: the energy's largest growth in so many steps.
double explicit_growth(Specimen& specimen, const LinearSystem& linear, double dt, Motion motion, int steps) {
  const double start = energy(linear, motion);
  double largest = 1;
  for (int i = 0; i < steps && largest < 1e9; ++i) {
    const Eigen::VectorXd force = -linear.stiffness * motion.displacement;
    for (int k = 0; k < force.size(); ++k) motion.velocity[k] += dt * force[k] / linear.masses[k / 3];
    motion.displacement += dt * motion.velocity;
    largest = std::max(largest, energy(linear, motion) / start);
  }
  (void)specimen;
  return largest;
}

/// A step of the nonlinear body under constant external forces.
void step_explicitly(Specimen& specimen, double dt, const std::vector<Vec3>& external) {
  WorldState& world = specimen.world();
  std::vector<Vec3> forces = specimen.elastic_forces();
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] += external[i];
  explicit_step(dt, 0, world.bodies[0].nodes, world.nodes.constraints, world.nodes.masses, forces,
                world.nodes.positions, world.nodes.velocities);
  update_elements(world);
}

}  // namespace

std::vector<Row> longitudinal_wave(Extent) {
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (int cells : {1, 2, 4}) {
      Scene scene = validation_scene("bar_wave");
      auto& box = std::get<BoxShape>(scene.bodies[0].shape);
      box.pattern = pattern;
      box.element_size = Vec3::Constant(box.size.y() / cells);
      const Material& material = scene.bodies[0].material;
      Specimen specimen(scene);
      WorldState& world = specimen.world();
      world.bodies[0].system->assemble(MatrixFactors{0, 1}, elastic_law(material), world.elements.rests,
                                       world.elements.states, world.nodes.positions, world.nodes.masses);
      Eigen::VectorXd masses(world.bodies[0].system->matrix().rows());
      for (int row = 0; row < masses.size(); ++row)
        masses[row] = world.nodes.masses[world.bodies[0].system->nodes()[row]];
      const double dt = stable_time_step(highest_frequency(world.bodies[0].system->matrix(), masses));
      std::vector<Vec3> loads(specimen.node_count(), Vec3::Zero());
      add_load_forces(world, 0, loads);
      const double end = box.size.x() / 2;
      const std::vector<int> tip = specimen.nodes_where([&](const Vec3& x) { return x.x() > end - 1e-9; });
      const double particle = scene.bodies[0].loads[0].traction.norm() / (material.density * bar_wave_speed(material));
      const double travel = box.size.x() / bar_wave_speed(material);
      std::array<double, 5> levels = {0.02, 0.1, 0.25, 0.5, 1.0};
      std::array<double, 5> times = {};
      double before = 0;
      for (int i = 1; i * dt < 1.5 * travel; ++i) {
        step_explicitly(specimen, dt, loads);
        double now = 0;
        for (int node : tip) now += world.nodes.velocities[node].x() / (static_cast<double>(tip.size()) * 2 * particle);
        for (int k = 0; k < 5; ++k)
          if (times[k] == 0 && now >= levels[k]) times[k] = (i - (now - levels[k]) / (now - before)) * dt;
        before = now;
      }
      for (int k = 0; k < 5; ++k)
        rows.push_back(near(mesh_label(pattern, cells), formatted("arrival at level %.2g", levels[k]), 0.992,
                            times[k] / travel, 0.002));
    }
  return rows;
}

std::vector<Row> free_fall(Extent) {
  constexpr int kSteps = 120;
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (double young_modulus : {1e4, 1e6, 1e8, 1e10, 4e11}) {
      Scene scene = validation_scene("free_fall");
      BodyDescription& body = scene.bodies[0];
      body.material.young_modulus = young_modulus;
      std::get<BoxShape>(body.shape).pattern = pattern;
      World world(scene);
      const double h = scene.simulation.time_step;
      double error = 0, strain = 0;
      for (int i = 1; i <= kSteps; ++i) {
        world.step();
        const Frame frame = world.frame();
        const double t = i * h;
        const Vec3 path = t * body.velocity + t * (t + h) / 2 * scene.gravity;
        for (std::size_t node = 0; node < frame.positions.size(); ++node)
          error = std::max(error, (frame.positions[node] - frame.rest_positions[node] - path).norm() / path.norm());
        for (const Mat3& stress : frame.stresses) strain = std::max(strain, stress.norm() / young_modulus);
      }
      const MeshLabel mesh = mesh_label(pattern, 4);
      rows.push_back(at_most(mesh, formatted("E = %.0e Pa: error of the path", young_modulus), 1e-9, error));
      rows.push_back(at_most(mesh, formatted("E = %.0e Pa: stress / E", young_modulus), 1e-9, strain));
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
      const ImplicitStep step{.dt = 1 / modes.frequencies[last / 2], .relative_residual = 1e-14, .max_iterations = 2000};
      Motion motion{1e-3 * modes.shapes.col(mode), 1e-3 * omega * modes.shapes.col(mode)};
      const double start = energy(linear, motion);
      constexpr int kSteps = 5;
      for (int i = 0; i < kSteps; ++i) step_implicitly(specimen, linear, step, motion);
      const double decay = std::pow(1 + std::pow(omega * step.dt, 2), -kSteps);
      rows.push_back(at_most(mesh, formatted("|energy ratio · (1+ω²h²)^5 − 1|, ωh = %.3g", omega * step.dt), 1e-10,
                             std::abs(energy(linear, motion) / start / decay - 1)));
    }
    linear_system(specimen);  // leaves the stiffness alone in the system's matrix
    const double estimate = highest_frequency(linear.system.matrix(), linear.masses);
    rows.push_back(near(mesh, "highest frequency, Lanczos / eigenvalue", 1, estimate / modes.frequencies[last], 0.01));
    const Motion start{modes.shapes * Eigen::VectorXd::Ones(last + 1), Eigen::VectorXd::Zero(last + 1)};
    rows.push_back(at_most(mesh, "explicit, stable step: energy's growth in 10,000 steps", 20,
                           explicit_growth(specimen, linear, stable_time_step(estimate), start, 10000)));
    rows.push_back(at_least(mesh, "explicit, 1.01 · 2/ω: energy's growth", 1e9,
                            explicit_growth(specimen, linear, 1.01 * 2 / modes.frequencies[last], start, 10000)));
  }
  return rows;
}

}  // namespace griffith::validation
