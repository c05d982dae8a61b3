// Scenes of many bodies, whose equal shapes are meshed once and which are completed in parallel.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/world/setup/shape_mesh.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// Blocks and plates of a few kinds in turn, each turned otherwise, the lowest held at their feet.
Scene heap(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.name = "block " + std::to_string(i);
    body.shape = i % 3 == 0 ? Shape(BoxShape{Vec3(0.2, 0.2, 0.4), Vec3::Constant(0.2), BoxPattern::five_tet})
                            : Shape(NotchedBeamShape{Vec3(0.4, 0.1 * (1 + i % 2), 0.1), 0.05, Vec3::Constant(0.1)});
    body.position = 0.45 * Vec3(i % 5, i / 25 + 0.5, i / 5 % 5);
    body.rotation_degrees = Vec3(3 * i, 17 * i, 29 * i);
    body.angular_velocity = Vec3(0, 0.1 * i, 1);
    if (i < 5) body.supports = {{HalfSpaceRegion{Vec3::Zero(), -Vec3::UnitY()}}};
  }
  return scene;
}

std::uint64_t hash_of_heap(int steps, int threads) {
  const ThreadLimit limit(threads);
  World world(heap(200));
  for (int i = 0; i < steps; ++i) world.step();
  return world.state_hash();
}

TEST(ManyBodies, TheSameBitsForOneTwoAndFourThreads) {
  for (const int steps : {0, 5}) {
    const std::uint64_t one = hash_of_heap(steps, 1);
    EXPECT_EQ(hash_of_heap(steps, 2), one);
    EXPECT_EQ(hash_of_heap(steps, 4), one);
  }
}

TEST(ManyBodies, EachIsAsItIsAlone) {
  const Scene scene = heap(30);
  const World all(scene);
  std::size_t node = 0, tet = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Scene single = scene;
    single.bodies = {scene.bodies[i]};
    const World alone(single);
    const Frame one = alone.frame(), frame = all.frame();
    for (std::size_t n = 0; n < one.nodes.positions.size(); ++n, ++node) {
      EXPECT_EQ(frame.nodes.positions[node], one.nodes.positions[n]);
      EXPECT_EQ(frame.nodes.velocities[node], one.nodes.velocities[n]);
      EXPECT_EQ(frame.nodes.masses[node], one.nodes.masses[n]);
      EXPECT_EQ(frame.nodes.has_support[node], one.nodes.has_support[n]);
      EXPECT_EQ(frame.nodes.at_crack_front[node], one.nodes.at_crack_front[n]);
    }
    for (std::size_t t = 0; t < one.elements.tets.size(); ++t, ++tet) {
      EXPECT_EQ(frame.elements.bodies[tet], BodyId(static_cast<int>(i)));
      EXPECT_EQ(frame.elements.first_surface[tet], one.elements.first_surface[t]);
      EXPECT_EQ(frame.elements.stresses[tet], one.elements.stresses[t]);
    }
  }
  EXPECT_EQ(node, all.frame().nodes.positions.size());
  EXPECT_EQ(tet, all.frame().elements.tets.size());
}

TEST(ManyBodies, TurnedCollisionPartsOfAShapeAreThoseOfTheTurnedBody) {
  Scene scene = heap(12);
  for (BodyDescription& body : scene.bodies) body.supports.clear();
  World world(scene);
  std::vector<std::vector<std::vector<Vec3>>> first;
  for (const BodyView& body : world.frame().bodies)
    first.emplace_back(body.collision_parts.begin(), body.collision_parts.end());
  // Another material recomputes everything that follows from a body's nodes.
  for (int i = 0; i < 12; ++i) world.set_material(i, scene.bodies[i].material);
  for (const BodyView& body : world.frame().bodies) {
    ASSERT_EQ(body.collision_parts.size(), first[body.id].size());
    for (std::size_t part = 0; part < first[body.id].size(); ++part)
      for (const Vec3& corner : first[body.id][part]) {
        double distance = 1;
        for (const Vec3& other : body.collision_parts[part]) distance = std::min(distance, (corner - other).norm());
        EXPECT_LT(distance, 1e-12);
      }
  }
}

TEST(ManyBodies, EqualShapesShareAMesh) {
  const Scene scene = heap(30);
  ShapeMeshes shapes;
  std::vector<const ShapeMesh*> meshes;
  for (int i = 0; i < 30; ++i) meshes.push_back(&shapes.of(scene, i, {}));
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_EQ(meshes[i] == meshes[j], scene.bodies[i].shape == scene.bodies[j].shape) << i << ", " << j;
  EXPECT_TRUE(meshes[0]->slit_tips.empty());
  EXPECT_FALSE(meshes[1]->slit_tips.empty());
}

std::string problem_of(const Scene& scene) {
  try {
    const World world(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// A thousand in one place would be half a million contacts.
TEST(ManyBodies, ACrowdOfProjectilesIsRefused) {
  Scene scene;
  ProjectileBurst burst;
  burst.count = 1000;
  burst.interval = 0.011;  // .44 m of flight, more than the diameter
  scene.projectiles = {burst};
  EXPECT_EQ(problem_of(scene), "none");
  scene.projectiles[0].interval = 0;
  EXPECT_TRUE(problem_of(scene).starts_with("#/projectiles: start inside more than 32 others")) << problem_of(scene);
  scene.projectiles[0].count = 33;
  EXPECT_EQ(problem_of(scene), "none");
  scene.projectiles.resize(2, scene.projectiles[0]);
  EXPECT_NE(problem_of(scene), "none");
  scene.projectiles[1].start = 0.5;
  EXPECT_EQ(problem_of(scene), "none");
}

TEST(ManyBodies, ShotsAndMaterialsThatAreNoneAreRefused) {
  World world((Scene()));
  for (const auto& spoil : std::vector<std::function<void(ProjectileBurst&)>>{
           [](ProjectileBurst& burst) { burst.count = 0; }, [](ProjectileBurst& burst) { burst.speed = NAN; },
           [](ProjectileBurst& burst) { burst.direction.setZero(); }}) {
    ProjectileBurst burst;
    world.fire(burst);
    spoil(burst);
    EXPECT_THROW(world.fire(burst), InputError);
  }
  EXPECT_THROW(world.set_material(0, {}), InputError);
}

/// Refused while it runs as in a file, and then as if it had not been fired.
TEST(ManyBodies, ACrowdOfShotsIsRefused) {
  World world((Scene()));
  ProjectileBurst burst;
  burst.interval = 0;
  burst.count = 1000;
  EXPECT_THROW(world.fire(burst), InputError);
  burst.count = 20;
  world.fire(burst);
  EXPECT_THROW(world.fire(burst), InputError) << "with those that wait there";
  world.step();
  EXPECT_EQ(world.frame().projectiles.size(), 20u);
}

TEST(ManyBodies, MoreShotsThanASceneMayHaveAreRefused) {
  Scene scene;
  ProjectileBurst burst;
  burst.count = 6000;
  burst.interval = 1;
  scene.projectiles = {burst};
  World world(scene);
  world.step();
  burst.count = 4001;
  burst.start = 1e4;
  EXPECT_THROW(world.fire(burst), InputError);
  burst.count = 4000;
  EXPECT_NO_THROW(world.fire(burst));
}

TEST(ManyBodies, ACrowdOfBodiesIsRefused) {
  Scene scene;
  for (int i = 0; i < 1500; ++i) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.name = std::to_string(i);
    body.shape = BoxShape{Vec3::Ones(), Vec3::Ones(), BoxPattern::five_tet};
    body.position = Vec3(2 * (i % 50), 2 * (i / 50), 0);
  }
  EXPECT_EQ(problem_of(scene), "none");
  for (BodyDescription& body : scene.bodies) body.position = Vec3::Zero();
  EXPECT_TRUE(problem_of(scene).starts_with("#/bodies: stand inside one another")) << problem_of(scene);
}

/// A thousand rods lie on a thousand across them: a million pairs touch.
TEST(ManyBodies, BodiesThatTouchAreNoCrowd) {
  constexpr int kRods = 1001;
  Scene scene;
  for (int i = 0; i < 2 * kRods; ++i) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.name = std::to_string(i);
    const double aside = i / 2 - kRods / 2;
    const Vec3 size = i % 2 ? Vec3(kRods, 1, 1) : Vec3(1, 1, kRods);
    body.shape = BoxShape{size, size, BoxPattern::five_tet};
    body.position = i % 2 ? Vec3(0, 1.5, aside) : Vec3(aside, 0.5, 0);
  }
  EXPECT_EQ(problem_of(scene), "none");
}

/// Equal shapes count too, although they share their mesh.
TEST(ManyBodies, TetsOfAllFilesTogetherAreLimited) {
  Scene scene;
  for (int i = 0; i < 900; ++i) {
    BodyDescription& body = scene.bodies.emplace_back();
    body.name = std::to_string(i);
    body.shape = BoxShape{Vec3::Ones(), Vec3::Constant(0.1), BoxPattern::five_tet};  // 5000 tets
  }
  EXPECT_TRUE(problem_of(scene).starts_with("#/bodies/800/shape: brings the scene to more than 4 million"));
}

}  // namespace
}  // namespace griffith
