#include "sim/world/setup/starting_overlaps.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <numbers>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

BodyDescription box(const std::string& name, const Vec3& size, const Vec3& position) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, Vec3::Constant(0.5), BoxPattern::five_tet};
  body.position = position;
  return body;
}

std::vector<InputError> overlaps_of(const Scene& scene) { return starting_overlaps(scene, World(scene).frame()); }

TEST(StartingOverlaps, BodiesThatTouchOrHaveAGapHaveNone) {
  Scene scene;
  scene.ground = Ground();
  scene.bodies = {box("low", Vec3::Ones(), Vec3(0, 0.5, 0)), box("high", Vec3::Ones(), Vec3(0.3, 1.5, 0)),
                  box("far", Vec3::Ones(), Vec3(3, 0.6, 0))};
  EXPECT_THAT(overlaps_of(scene), IsEmpty());
}

TEST(StartingOverlaps, TellWhoIsInsideWhomAndHowFarTheDeepestFirst) {
  Scene scene;
  scene.ground = Ground{2};
  scene.bodies = {box("left", Vec3::Ones(), Vec3(0, 3, 0)), box("right", Vec3::Ones(), Vec3(0.9, 3, 0)),
                  box("sunk", Vec3::Ones(), Vec3(5, 2.25, 0))};
  const std::vector<InputError> overlaps = overlaps_of(scene);
  ASSERT_EQ(overlaps.size(), 2u);
  EXPECT_EQ(overlaps[0].where(), "#/bodies/2/position");
  EXPECT_EQ(overlaps[0].problem(), "\"sunk\" starts 0.25 m under the ground");
  EXPECT_EQ(overlaps[1].where(), "#/bodies/1/position");
  EXPECT_EQ(overlaps[1].problem(), "\"right\" starts 0.1 m inside \"left\"");
}

TEST(StartingOverlaps, OfTurnedBodiesAreThoseOfTheirShapes) {
  Scene scene;
  scene.ground.reset();
  scene.bodies = {box("upright", Vec3::Ones(), Vec3::Zero()), box("on edge", Vec3::Ones(), Vec3(1.1, 0, 0))};
  scene.bodies[1].rotation_degrees = Vec3(0, 0, 45);  // reaches 1/√2 to each side
  const std::vector<InputError> overlaps = overlaps_of(scene);
  ASSERT_EQ(overlaps.size(), 1u);
  char depth[32];
  std::snprintf(depth, sizeof depth, "starts %.3g m inside", 0.5 + std::numbers::sqrt2 / 2 - 1.1);
  EXPECT_THAT(overlaps[0].problem(), HasSubstr(depth));
}

TEST(StartingOverlaps, BodiesThatAreHeldCountToo) {
  Scene scene;
  scene.ground.reset();
  scene.bodies = {box("left", Vec3::Ones(), Vec3::Zero()), box("right", Vec3::Ones(), Vec3(0.5, 0, 0))};
  for (BodyDescription& body : scene.bodies) body.supports = {{BoxRegion{Vec3(-1, -1, -1), Vec3(1, -0.5, 1)}}};
  EXPECT_EQ(overlaps_of(scene).size(), 1u);
}

/// Its convex parts overlap the pane on both sides, where contacts would clamp it.
TEST(StartingOverlaps, ThinPanesInsideAHollowBodyCount) {
  Scene scene = read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes" / "vase_shot.json");
  scene.bodies.resize(1);
  scene.projectiles.clear();
  BodyDescription& pane = scene.bodies.emplace_back(box("pane", Vec3(3, 0.01, 3), Vec3::Zero()));
  for (const double height : {0.05, 0.3, 0.45}) {
    pane.position = scene.bodies.front().position + Vec3(0, height, 0);
    EXPECT_THAT(overlaps_of(scene), Not(IsEmpty())) << height;
  }
}

TEST(StartingOverlaps, ShippedScenesHaveNone) {
  for (const char* name : {"arch", "block_stack", "bridge", "column_collapse", "plate_drop", "wall_small"}) {
    const auto path = std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes" / (std::string(name) + ".json");
    EXPECT_THAT(overlaps_of(read_scene(path)), IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace griffith
