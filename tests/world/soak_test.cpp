#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// Draws scenes from everything that a user may enter.
class RandomScenes {
 public:
  explicit RandomScenes(unsigned seed) : random_(seed) {}

  Scene next() {
    const double size = logarithmic(1e-3, 1e3);
    const double gravity = uniform() < 0.3 ? 0 : 9.81;
    Scene scene;
    scene.gravity = Vec3(0, -gravity, 0);
    scene.ground->height = -size;
    scene.simulation.time_step = logarithmic(1e-4, 1.0 / 30);
    scene.simulation.impact_substeps = 8;
    for (int i = 0; i < 2; ++i) scene.bodies.push_back(body(size, i));
    scene.projectiles = {shot(size)};
    return scene;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  double logarithmic(double minimum, double maximum) { return minimum * std::pow(maximum / minimum, uniform()); }
  Vec3 direction() { return Vec3(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5).normalized(); }

  BodyDescription body(double size, int index) {
    BodyDescription made;
    made.name = "body " + std::to_string(index);
    made.shape = BoxShape{size * Vec3(1, 0.5 + uniform(), 0.2 + 0.5 * uniform()), Vec3::Constant(size / 2),
                          BoxPattern::five_tet};
    made.position = Vec3(0, 1.8 * size * index, 0);
    made.rotation_degrees = 180 * direction();
    made.velocity = uniform() < 0.5 ? Vec3(Vec3::Zero()) : Vec3(logarithmic(0.1, 50) * direction());
    made.material.young_modulus = logarithmic(1e4, 4e11);
    made.material.poisson_ratio = 0.49 * uniform();
    made.material.density = logarithmic(10, 2e4);
    made.material.tensile_strength = logarithmic(1e3, 1e9);
    made.material.fracture_toughness = logarithmic(1e3, 1e8);
    return made;
  }

  ProjectileBurst shot(double size) {
    ProjectileBurst made;
    made.position = Vec3(0, 0, 2 * size);
    made.speed = logarithmic(0.1, 300);
    made.mass = logarithmic(1e-6, 1e6);
    made.radius = size * logarithmic(0.05, 0.5);
    return made;
  }

  std::mt19937 random_;
};

double mass_of_bodies(const Frame& frame) {
  return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
}

/// Returns kinetic, elastic and potential energy of all that moves, the last one about the origin [J].
double energy_of(const Frame& frame, const Vec3& gravity) {
  double energy = frame.totals.kinetic_energy + frame.totals.elastic_energy;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
    energy -= frame.nodes.masses[i] * gravity.dot(frame.nodes.positions[i]);
  for (const ProjectileView& projectile : frame.projectiles)
    energy -= projectile.mass * gravity.dot(projectile.position);
  return energy;
}

TEST(Soak, AnySceneStaysFiniteAndKeepsItsMassAndGainsNoEnergy) {
  RandomScenes scenes(17);
  for (int trial = 0; trial < 60; ++trial) {
    const Scene scene = scenes.next();
    World world(scene);
    const double mass = mass_of_bodies(world.frame());
    world.step();  // launches the projectile
    const double first = energy_of(world.frame(), scene.gravity);
    for (int step = 0; step < 30; ++step) {
      world.step();
      const Frame frame = world.frame();
      for (const Vec3& position : frame.nodes.positions) ASSERT_TRUE(position.allFinite()) << trial;
      ASSERT_EQ(frame.report.non_finite_values, 0) << trial;
      ASSERT_NEAR(mass_of_bodies(frame), mass, 1e-9 * mass) << trial;
      ASSERT_LE(energy_of(frame, scene.gravity), first + 1e-3 * frame.energy.turned_over())
          << trial << " step " << step;
    }
  }
}

}  // namespace
}  // namespace griffith
