#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mesh/box_mesh.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

const Vec3 kBoxSize(1, 2, 0.5), kBoxCell(0.25, 0.25, 0.25);

/// Something that falls on the ground and breaks there.
Scene drop(const Shape& shape) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].shape = shape;
  scene.bodies[0].position = {0, 2, 0};
  scene.bodies[0].rotation_degrees = {0, 0, 30};
  scene.bodies[0].velocity = {0, -20, 0};
  return scene;
}

std::uint64_t hash_after(World world, int steps) {
  for (int step = 0; step < steps; ++step) world.step();
  return world.state_hash();
}

TEST(InMemoryMeshes, AreWhatTheSameShapeIs) {
  const std::uint64_t expected = hash_after(World(drop(BoxShape{kBoxSize, kBoxCell, BoxPattern::kuhn})), 30);
  const TetSoup box = make_box(kBoxSize, kBoxCell, BoxPattern::kuhn);
  EXPECT_EQ(hash_after(World(drop(MeshFileShape{"a box"}), {{"a box", box}}), 30), expected);

  TetSoup in_quarters = box;
  for (Vec3& point : in_quarters.points) point *= 4;
  for (std::array<int, 4>& tet : in_quarters.tets) std::swap(tet[0], tet[1]);  // prepare() turns them round
  const World scaled(drop(MeshFileShape{"a box", 0.25}), {{"a box", in_quarters}});
  EXPECT_THAT(scaled.frame().nodes.rest_positions, ::testing::SizeIs(box.points.size()));
  EXPECT_NEAR(scaled.frame().totals.mass, kBoxSize.prod() * Material().density, 1e-9);
}

TEST(InMemoryMeshes, ThatCannotBeSimulatedAreNamed) {
  TetSoup soup = make_box(kBoxSize, kBoxCell, BoxPattern::kuhn);
  soup.tets[7][2] = 12345;
  try {
    const World world(drop(MeshFileShape{"a box"}), {{"a box", soup}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/shape/mesh");
    EXPECT_THAT(error.problem(), ::testing::AllOf(::testing::HasSubstr("a box"), ::testing::HasSubstr("12345")));
  }
  EXPECT_THROW(World(drop(MeshFileShape{"another"}), {{"a box", soup}}), InputError);
}

}  // namespace
}  // namespace griffith
