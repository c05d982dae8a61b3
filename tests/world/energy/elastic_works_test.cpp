#include "sim/world/energy/elastic_works.h"

#include <gtest/gtest.h>

#include "sim/world/bodies/bodies.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/setup/build_world.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

constexpr double kStep = 1e-3;

/// A strained block of some tets (their number is no multiple of four) with velocities that deform it.
WorldState moving_block(ElementModel model) {
  Scene scene;
  scene.ground.reset();
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(1), BoxPattern::five_tet};
  block.material.element_model = model;
  scene.bodies = {block};
  WorldState world = build_world(scene);
  testing::RandomValues random(4);
  for (Vec3& position : world.nodes.positions) position += random.vector(1e-3);
  for (Vec3& velocity : world.nodes.velocities) velocity = random.vector(1e-5);
  world.scratch.substep_start.deforming_velocities = world.nodes.velocities;
  update_elements(world);
  return world;
}

class ElasticWorksTest : public ::testing::TestWithParam<ElementModel> {};

TEST_P(ElasticWorksTest, AreThoseOfTheNodalForcesOverTheWay) {
  const WorldState world = moving_block(GetParam());
  double work = 0;
  for (TetId tet : world.bodies[0].tets) {
    const ElementState& state = world.elements.states[tet];
    const Corners forces = nodal_forces(world.elements.rest_elements[tet], state.frame, state.stress);
    for (int i = 0; i < 4; ++i) work -= kStep * forces.col(i).dot(world.nodes.velocities[world.mesh->tets[tet][i]]);
  }
  const ElasticWorks works = elastic_works(world, world.bodies[0], kStep);
  EXPECT_NEAR(works.first, work, 1e-10 * std::abs(work));
}

TEST_P(ElasticWorksTest, ChangeByTheSystemsStiffness) {
  WorldState world = moving_block(GetParam());
  const Body& body = world.bodies[0];
  ElasticSystem system = *body.system;
  system.assemble(MatrixFactors{0, 1}, elastic_law(world.material_of(body)), world.elements.rest_elements,
                  world.elements.states, world.nodes.positions, world.nodes.masses);
  const NodeVectors way = kStep * system.gather(world.nodes.velocities);
  NodeVectors forces;
  multiply(system.matrix(), way, forces);
  const ElasticWorks works = elastic_works(world, body, kStep);
  EXPECT_NEAR(works.change, dot(way, forces), 1e-9 * works.change);
  EXPECT_GT(works.change, 0);
}

/// Motion of a body as a whole neither does work nor changes the forces in axes that move along.
TEST_P(ElasticWorksTest, ChangeOverWhatDeformsAlone) {
  WorldState world = moving_block(GetParam());
  const Body& body = world.bodies[0];
  const ElasticWorks still = elastic_works(world, body, kStep);
  std::vector<Vec3>& deforming = world.scratch.substep_start.deforming_velocities;
  for (const NodeId node : body.nodes) deforming[node] *= 0.25;
  const ElasticWorks works = elastic_works(world, body, kStep);
  EXPECT_NEAR(works.first, 0.25 * still.first, 1e-12 * std::abs(still.first));
  EXPECT_NEAR(works.change, 0.0625 * still.change, 1e-12 * still.change);
}

TEST_P(ElasticWorksTest, NothingIsStoredByWhatDoesNotMove) {
  const WorldState world = moving_block(GetParam());
  const ElasticWorks works = elastic_works(world, world.bodies[0], kStep);
  ASSERT_EQ(works.energy_densities.size(), world.bodies[0].tets.size());
  EXPECT_LT(std::abs(stored_since(world, world.bodies[0], works)), 1e-10 * std::abs(works.first) / kStep);
}

INSTANTIATE_TEST_SUITE_P(Models, ElasticWorksTest,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain),
                         [](const auto& model) {
                           return model.param == ElementModel::corotational ? "Corotational" : "GreenStrain";
                         });

/// Elements without storage for strains have none, and are hashed and copied the same.
TEST(Strains, TakeRoomWhereTheyCanBeOtherThanZero) {
  WorldState world = moving_block(ElementModel::corotational);
  ASSERT_TRUE(world.elements.plastic_strains.empty());
  EXPECT_TRUE(world.elements.stress_free_strain(TetId(0)).isZero(0));
  const std::size_t before = world.elements.memory();
  world.elements.append_copy(TetId(0));
  EXPECT_TRUE(world.elements.plastic_strains.empty());
  world.elements.allow_strains();
  EXPECT_EQ(world.elements.plastic_strains.size(), world.elements.states.size());
  EXPECT_GT(world.elements.memory(), before);
  world.elements.plastic_strains[0](1, 1) = 0.5;
  world.elements.allow_strains();
  world.elements.append_copy(TetId(0));
  EXPECT_EQ(world.elements.plastic_strain(TetId(static_cast<int>(world.elements.states.size()) - 1))(1, 1), 0.5);
}

}  // namespace
}  // namespace griffith
