// Bodies that supports leave free to rotate about a hinge, among so many other objects that all are quasi-static.

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A plank of 2 m, hinged along one lower edge half a meter above the ground, with a row of blocks on it.
Scene plank_on_a_hinge(double young_modulus) {
  Scene scene;
  scene.simulation.fracture = false;
  BodyDescription plank;
  plank.shape = BoxShape{Vec3(2, 0.2, 0.5), Vec3(0.5, 0.2, 0.5), BoxPattern::kuhn};
  plank.position = Vec3(0, 0.6, 0);
  plank.material.young_modulus = young_modulus;
  plank.supports = {{BoxRegion{Vec3(-1.01, -0.11, -1), Vec3(-0.99, -0.09, 1)}}};
  scene.bodies.push_back(plank);
  for (int i = 0; i < 6; ++i) {
    BodyDescription block = plank;
    block.supports.clear();
    block.shape = BoxShape{Vec3(0.2, 0.2, 0.4), Vec3(0.2, 0.2, 0.4), BoxPattern::five_tet};
    block.position = Vec3(-0.75 + 0.3 * i, 0.81, 0);
    scene.bodies.push_back(block);
  }
  return scene;
}

double lowest_node(const Frame& frame) {
  return std::ranges::min_element(frame.nodes.positions, {}, [](const Vec3& place) { return place.y(); })->y();
}

/// Contacts rotate a stiff plank as a rigid body; a soft one deforms.
class HingedPlank : public ::testing::TestWithParam<double> {};

TEST_P(HingedPlank, FallsToTheGroundAndStaysThere) {
  World world(plank_on_a_hinge(GetParam()));
  double least = 1;
  for (int step = 0; step < 240; ++step) {
    world.step();
    least = std::min(least, lowest_node(world.frame()));
  }
  EXPECT_GT(least, -0.02);                      // a percent of its length
  EXPECT_LT(lowest_node(world.frame()), 2e-3);  // it has come down
  EXPECT_EQ(world.frame().report.unconverged_contacts, 0);
}
INSTANTIATE_TEST_SUITE_P(Stiffness, HingedPlank, ::testing::Values(2e11, 1.5e10, 1e8));

}  // namespace
}  // namespace griffith
