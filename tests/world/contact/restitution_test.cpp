// Impacts of bodies that deform but do not break: their waves end within a step, which damps them, so that the
// coefficient of restitution includes them.

#include <gtest/gtest.h>

#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::kEarthGravity;
using testing::preset;

/// Object that a falling cube meets.
enum class Target { ground, held, lying };

constexpr double kCubeSize = 0.1, kCubeGap = 0.05, kCubeSpeed = 3;

Material steel(double restitution) {
  Material material = preset("mild_steel");
  material.restitution = restitution;
  return material;
}

/// A cube of steel above the ground, or above a slab that is held at its foot or lies on the ground. Both are still
/// deformable when they meet.
Scene dropped_cube(Target target, double restitution, double time_step) {
  Scene scene;
  scene.simulation.time_step = time_step;
  scene.ground = Ground{-kCubeSize, 0.6, restitution};
  if (target == Target::ground) scene.ground->height = 0;
  const Vec3 cell = Vec3::Constant(kCubeSize / 2);
  scene.bodies = {
      box("cube", Vec3::Constant(kCubeSize), Vec3(0, kCubeSize / 2 + kCubeGap, 0), steel(restitution), cell)};
  scene.bodies[0].velocity = Vec3(0, -kCubeSpeed, 0);
  if (target == Target::ground) return scene;
  scene.bodies.push_back(
      box("slab", kCubeSize * Vec3(4, 1, 4), Vec3(0, -kCubeSize / 2, 0), steel(restitution), 2 * cell));
  if (target == Target::held)
    scene.bodies[1].supports = {Support{HalfSpaceRegion{Vec3(0, -kCubeSize / 2 + 1e-3, 0), -Vec3::UnitY()}}};
  return scene;
}

/// Returns the height to which the cube rises over where it lands [m].
double height_after(const Scene& scene) {
  World world(scene);
  double highest = 0;
  bool has_met = false;
  while (world.frame().time < 0.45) {
    world.step();
    const BodyView& cube = world.frame().bodies[0];
    has_met |= cube.velocity.y() > -0.5 * kCubeSpeed;
    if (has_met) highest = std::max(highest, cube.center_of_mass.y() - kCubeSize / 2);
    EXPECT_LT(testing::energy_gained(world.frame().energy), 1e-3);
  }
  return highest;
}

TEST(Restitution, OfDeformableBodiesIsThatOfTheirMaterialAtAnyStep) {
  const double fall = kCubeGap + kCubeSpeed * kCubeSpeed / (2 * kEarthGravity);
  for (const Target target : {Target::ground, Target::held, Target::lying})
    for (const double restitution : {0.6, 0.9})
      for (const double rate : {30.0, 60.0, 250.0})
        EXPECT_NEAR(height_after(dropped_cube(target, restitution, 1 / rate)), restitution * restitution * fall,
                    0.03 * fall + kCubeSpeed / (2 * rate))  // the fall of a step
            << static_cast<int>(target) << ", e " << restitution << ", 1/" << rate;
}

}  // namespace
}  // namespace griffith
