// The energy account of spinning bodies.

#include <gtest/gtest.h>

#include <utility>

#include "sim/world/world.h"
#include "tests/world/measures.h"

namespace griffith {
namespace {

/// A free block that spins about none of its axes [rad/s], and deforms by it.
Scene spinning_block(double young_modulus, double stiffness_damping, double spin) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  scene.simulation.integrator = Integrator::implicit;
  scene.simulation.relative_residual = 1e-8;
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 0.6, 0.3), Vec3::Constant(0.15), BoxPattern::five_tet};
  block.material.young_modulus = young_modulus;
  block.material.stiffness_damping = stiffness_damping;
  block.material.tensile_strength = 1e-2 * young_modulus;
  block.angular_velocity = spin * Vec3(1, 0.15, 0.25);
  scene.bodies = {block};
  return scene;
}

// What does not close is in proportion to the strain that the spin makes, some 2 % and 0.2 %.
TEST(EnergyAccount, OfASpinningPieceCloses) {
  for (const auto& [young_modulus, tolerance] : {std::pair(1e7, 2e-3), std::pair(1e8, 2e-4)})
    for (const double damping : {0.0, 1e-4, 1e-2}) {
      World world(spinning_block(young_modulus, damping, 20));
      for (int i = 0; i < 20; ++i) {
        world.step();
        const EnergyAccount energy = world.frame().energy;
        ASSERT_LT(testing::fraction_unaccounted(energy), tolerance) << "damping " << damping << " s, step " << i;
        EXPECT_GE(energy.material_damping, 0);
        EXPECT_EQ(energy.limited, 0);
      }
    }
}

TEST(EnergyAccount, ASpinningPieceKeepsItsEnergyOnceItsShapeHasSettled) {
  World world(spinning_block(1e8, 1e-3, 20));
  for (int i = 0; i < 20; ++i) world.step();
  const double before = world.frame().energy.stored();
  for (int i = 0; i < 100; ++i) world.step();
  EXPECT_NEAR(world.frame().energy.stored(), before, 1e-4 * before);
}

// The linearized step would tear so soft a piece apart at so fast a spin.
TEST(EnergyAccount, OfANonlinearStepCloses) {
  World world(spinning_block(1e7, 1e-3, 2000));
  world.step();
  const EnergyAccount energy = world.frame().energy;
  EXPECT_LE(energy.material_damping, energy.start);
  EXPECT_LE(energy.stored(), 1.001 * energy.start);
  EXPECT_LT(testing::fraction_unaccounted(energy), 1e-3);
}

}  // namespace
}  // namespace griffith
