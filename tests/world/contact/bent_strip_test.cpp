// A strip of glass bends by several times its thickness under a block of steel that is put on its middle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/world/contact/contact_scenes.h"

namespace griffith {
namespace {

using testing::box;
using testing::preset;
using testing::unbreakable;

constexpr double kStripSpan = 0.8, kStripWidth = 0.1, kStripThickness = 0.004, kStripHeight = 0.3;  // [m]
constexpr double kBlockWidth = 0.04, kBlockMass = 7850 * kBlockWidth * 0.1 * 0.1;
constexpr int kStrip = 0, kBlock = 3;  // bodies of the scene

Material glass(double strength) {
  Material material = preset("soda_lime_glass");
  material.tensile_strength = strength;
  return material;
}

/// A strip on two supports, and a block `above` its middle [m].
Scene loaded_strip(const Material& material, double time_step, double above = 1e-4) {
  Scene scene;
  scene.simulation.time_step = time_step;
  scene.bodies.push_back(box("strip", Vec3(kStripSpan + 0.08, kStripThickness, kStripWidth),
                             Vec3(0, kStripHeight + kStripThickness / 2, 0), material,
                             Vec3(0.04, kStripThickness, 0.05)));
  for (const double side : {-1.0, 1.0})
    scene.bodies.push_back(box(side < 0 ? "left" : "right", Vec3(0.04, kStripHeight, kStripWidth),
                               Vec3(side * (kStripSpan / 2 + 0.02), kStripHeight / 2, 0),
                               unbreakable(preset("granite")), Vec3(0.04, 0.1, 0.05)));
  scene.bodies.push_back(box("block", Vec3(kBlockWidth, 0.1, 0.1),
                             Vec3(0, kStripHeight + kStripThickness + 0.05 + above, 0),
                             unbreakable(preset("mild_steel")), Vec3(kBlockWidth, 0.05, 0.05)));
  return scene;
}

double bending_stiffness(const Material& material) {
  return material.young_modulus * kStripWidth * std::pow(kStripThickness, 3) / 12;
}

/// Deflection of a simply supported beam by forces at both edges of a block of this weight [m].
double deflection_by_block(const Material& material) {
  const double arm = (kStripSpan - kBlockWidth) / 2, force = kBlockMass * testing::kEarthGravity / 2;
  return force * arm * (3 * kStripSpan * kStripSpan - 4 * arm * arm) / (24 * bending_stiffness(material));
}

double deflection_by_weight(const Material& material) {
  const double load = material.density * kStripWidth * kStripThickness * testing::kEarthGravity;
  return 5 * load * std::pow(kStripSpan, 4) / (384 * bending_stiffness(material));
}

/// Returns the lowest that a side of a body, at this height at rest, is below its place [m].
double lowered_by(const Frame& frame, int body, double height) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const BodyView& view : frame.bodies) EXPECT_LT(view.scene_body, 4);
  for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node) {
    const std::vector<TetId>& star = frame.nodes.stars[NodeId(static_cast<int>(node))];
    if (frame.bodies[frame.elements.bodies[star.front()]].scene_body != body) continue;
    if (std::abs(frame.nodes.rest_positions[node].y() - height) < 1e-6)
      lowest = std::min(lowest, frame.nodes.positions[node].y());
  }
  return height - lowest;
}

/// Deflections of the strip, and overlap of the block with it [m].
struct Deflection {
  double strip = 0, overlap = 0;

  explicit Deflection(const Frame& frame, double above = 1e-4) {
    strip = lowered_by(frame, kStrip, kStripHeight + kStripThickness);
    overlap = lowered_by(frame, kBlock, kStripHeight + kStripThickness + above) - above - strip;
  }
};

TEST(BentStrip, CarriesABlockOnItsDeformedSurfaceAtEveryTimeStep) {
  const Material material = unbreakable(glass(0));
  const double at_rest = deflection_by_block(material) + deflection_by_weight(material);
  ASSERT_GT(at_rest, 2 * kStripThickness);
  for (const double rate : {60, 250}) {
    World world(loaded_strip(material, 1 / rate));
    while (world.frame().time < 1) {
      world.step();
      ASSERT_LT(Deflection(world.frame()).overlap, 0.1 * kStripThickness)
          << "at " << world.frame().time << " s, 1/" << rate;
    }
    EXPECT_NEAR(Deflection(world.frame()).strip, at_rest, 5e-3 * kStripSpan) << "at steps of 1/" << rate << " s";
    testing::run_to(world, 3);
    const BodyView& strip = world.frame().bodies[kStrip];
    EXPECT_TRUE(strip.asleep && !strip.rigid) << "the hull of a rigid one would fill the hollow";
    EXPECT_NEAR(Deflection(world.frame()).strip, at_rest, 0.03 * at_rest) << "at steps of 1/" << rate << " s";
  }
}

TEST(BentStrip, SwingsTwiceAsFarUnderASuddenLoad) {
  const Material material = unbreakable(glass(0));
  World world(loaded_strip(material, 1.0 / 500));
  double farthest = 0;
  while (world.frame().time < 0.15) {
    world.step();
    farthest = std::max(farthest, Deflection(world.frame()).strip);
  }
  EXPECT_NEAR(farthest, 2 * deflection_by_block(material) + deflection_by_weight(material), 0.06 * farthest);
}

TEST(BentStrip, BreaksUnderTheSameLoadAtEveryTimeStep) {
  const Material material = glass(4e7);
  const double bending = kBlockMass * testing::kEarthGravity / 2 * (kStripSpan - kBlockWidth) / 2,
               modulus = kStripWidth * kStripThickness * kStripThickness / 6, sudden = 2 * bending / modulus;
  for (const double rate : {30, 250})
    for (const double share : {0.9, 1.25}) {
      World world(loaded_strip(glass(share * sudden), 1 / rate));
      testing::run_to(world, 0.2);
      EXPECT_EQ(testing::has_crack(world.frame()), share < 1)
          << "strength " << share << " of the stress, steps of 1/" << rate << " s";
    }
}

/// A strip that has come to rest, and a block that a support lowers until the strip is bent as under its weight.
Scene pressed_strip(const Material& material) {
  constexpr double kAbove = 0.012, kSpeed = 0.02;  // [m], [m/s]
  Scene scene = loaded_strip(material, 1.0 / 60, kAbove);
  const double way = kAbove + deflection_by_block(material) + deflection_by_weight(material);
  scene.bodies[kBlock].supports = {{.region = HalfSpaceRegion{Vec3(0, 0.05, 0), Vec3::UnitY()},
                                    .kind = SupportKind::prescribed,
                                    .velocity = -kSpeed * Vec3::UnitY(),
                                    .stop = way / kSpeed}};
  return scene;
}

TEST(BentStrip, BendsUnderWhatIsLaidOnItAtRest) {
  World holds(pressed_strip(glass(7e7)));
  testing::run_to(holds, 1.5);
  EXPECT_FALSE(testing::has_crack(holds.frame()));
  double carried = 0;  // by the support of the block: nothing, where the strip carries all of its weight
  for (const Vec3& reaction : holds.frame().nodes.reactions) carried += reaction.y();
  EXPECT_NEAR(carried / (kBlockMass * testing::kEarthGravity), 0, 0.05);
  World breaks(pressed_strip(glass(2e7)));
  testing::run_to(breaks, 1.5);
  EXPECT_TRUE(testing::has_crack(breaks.frame())) << "its stress is 1.25 times its strength";
}

}  // namespace
}  // namespace griffith
