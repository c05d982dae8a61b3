#include "tests/fuzz/world_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "sim/mesh/topology.h"
#include "sim/world/world.h"
#include "tests/fuzz/target.h"
#include "tests/mesh/mesh_invariants.h"

namespace griffith::fuzz {
namespace {

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, numbers...);
  return buffer;
}

double mass_of_bodies(const Frame& frame) {
  return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
}

double energy_of(const Frame& frame) { return frame.totals.kinetic_energy + frame.totals.elastic_energy; }

double potential_energy(const Frame& frame, const Vec3& gravity) {
  double energy = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    energy -= frame.nodes.masses[i] * gravity.dot(frame.nodes.positions[i]);
  for (const ProjectileView& projectile : frame.projectiles)
    energy -= projectile.mass * gravity.dot(projectile.position);
  return energy;
}

/// Returns the effect of rounding of positions on the elastic energy.
double rounding_of(const Frame& frame) {
  constexpr double kRounding = 1e-13;
  double energy = 0;
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i) {
    const double volume = frame.elements.rest_elements[i].volume;
    const double strain = kRounding * (1 + frame.nodes.positions[frame.elements.tets[i][0]].norm() / std::cbrt(volume));
    energy +=
        frame.materials[frame.bodies[frame.elements.bodies[i]].scene_body].young_modulus * volume * strain * strain;
  }
  return energy;
}

bool does_work(const Support& support) { return support.kind == SupportKind::prescribed; }

/// True if only gravity, contact and projectiles can do work on the scene's bodies.
bool is_left_alone(const Scene& scene) {
  return scene.analysis == Analysis::dynamic && std::ranges::none_of(scene.bodies, [](const BodyDescription& body) {
           return !body.loads.empty() || std::ranges::any_of(body.supports, does_work);
         });
}

/// Follows a world from step to step.
class Watch {
 public:
  Watch(const Scene& scene, const Frame& frame, bool has_slivers)
      : scene_(scene),
        has_slivers_(has_slivers),
        mass_(mass_of_bodies(frame)),
        budget_(energy_of(frame) + potential_energy(frame, scene.gravity)),
        momentum_(frame.totals.momentum),
        largest_potential_(std::abs(potential_energy(frame, scene.gravity))) {}

  void check(const Frame& frame) {
    check_values(frame);
    launch(frame);
    if (!has_slivers_ && is_left_alone(scene_)) check_energy(frame);
    if (is_isolated()) check_momentum(frame);
    projectiles_ = frame.projectiles.size();
  }

 private:
  void check_values(const Frame& frame) const {
    for (const Vec3& position : frame.nodes.positions) promise(position.allFinite(), "a position is not finite");
    for (const Vec3& velocity : frame.nodes.velocities) promise(velocity.allFinite(), "a velocity is not finite");
    promise(frame.report.non_finite_values == 0, "bodies were frozen: values were not finite");
    const double mass = mass_of_bodies(frame);
    promise(std::abs(mass - mass_) <= 1e-9 * mass_, text("mass changed from %g to %g kg", mass_, mass));
    promise(frame.report.substeps >= 1, text("%d substeps", frame.report.substeps));
  }

  /// Adds the energy of new projectiles.
  void launch(const Frame& frame) {
    double speed = 0, spin = 0;
    for (const ProjectileBurst& burst : scene_.projectiles) {
      speed = std::max(speed, burst.speed);
      spin = std::max(spin, burst.angular_velocity.norm());
    }
    for (std::size_t i = projectiles_; i < frame.projectiles.size(); ++i) {
      const ProjectileView& projectile = frame.projectiles[i];
      const double surface_speed = spin * projectile.radius;
      budget_ += projectile.mass * (speed * speed + surface_speed * surface_speed) / 2;
      budget_ -= projectile.mass * scene_.gravity.dot(projectile.position);
      const double path = (speed + projectile.velocity.norm()) * scene_.simulation.time_step;
      slack_ += projectile.mass * scene_.gravity.norm() * path;
    }
    if (frame.projectiles.size() > projectiles_) momentum_ = frame.totals.momentum;
  }

  /// Allows what pushing overlaps apart lifts, and what rounding does.
  void check_energy(const Frame& frame) {
    constexpr double kFactor = 1.5;
    const double potential = potential_energy(frame, scene_.gravity);
    largest_potential_ = std::max(largest_potential_, std::abs(potential));
    penetration_ = std::max(penetration_, frame.report.max_penetration);
    const double fall = scene_.gravity.norm() * scene_.simulation.time_step;
    slack_ += frame.totals.mass * fall * fall;
    const double lifted = frame.totals.mass * scene_.gravity.norm() * penetration_;
    const double rounding = 1e-9 * largest_potential_ + rounding_of(frame);
    const double allowed = kFactor * std::max(budget_ - potential, 0.0) + slack_ + lifted + rounding;
    promise(energy_of(frame) <= allowed, text("energy appeared: %g J at step %d, where %g J are accounted for",
                                              energy_of(frame), static_cast<int>(frame.step), allowed));
  }

  /// True if nothing outside acts on the bodies.
  bool is_isolated() const {
    return is_left_alone(scene_) && scene_.gravity.isZero(0) && !scene_.ground &&
           std::ranges::all_of(scene_.bodies, [](const BodyDescription& body) {
             return body.supports.empty() && body.material.mass_damping == 0;
           });
  }

  void check_momentum(const Frame& frame) {
    const double scale = std::sqrt(2 * frame.totals.mass * energy_of(frame)) + momentum_.norm();
    const double change = (frame.totals.momentum - momentum_).norm();
    promise(change <= 1e-6 * scale + 1e-12 * frame.totals.mass,
            text("momentum changed by %g of %g N s", change, scale));
  }

  const Scene& scene_;
  bool has_slivers_;
  double mass_, budget_;  ///< budget: all energy that may ever be there [J]
  Vec3 momentum_;
  double slack_ = 0, penetration_ = 0, largest_potential_;
  std::size_t projectiles_ = 0;
};

void check_mesh(const Frame& frame) {
  const TetMesh mesh = {{frame.nodes.rest_positions.begin(), frame.nodes.rest_positions.end()},
                        {frame.elements.tets.begin(), frame.elements.tets.end()},
                        {frame.elements.neighbors.begin(), frame.elements.neighbors.end()},
                        {frame.nodes.stars.begin(), frame.nodes.stars.end()}};
  const std::vector<std::string> faults = testing::check_invariants(mesh);
  promise(faults.empty(), "the mesh is unsound: " + (faults.empty() ? "" : faults.front()));
}

}  // namespace

void run_world(const Scene& scene, int max_steps, bool has_slivers) {
  constexpr int kWork = 3000;  ///< steps times tets
  World world(scene);
  check_mesh(world.frame());
  Watch watch(scene, world.frame(), has_slivers);
  const int tets = 1 + static_cast<int>(world.frame().elements.tets.size());
  for (int steps = std::clamp(kWork / tets, 2, max_steps); steps > 0; --steps) {
    world.step();
    watch.check(world.frame());
  }
  check_mesh(world.frame());
}

}  // namespace griffith::fuzz
