// Scenes and worlds of the C interface: errors with their places, copies, recordings, and nothing left behind.
#include <malloc.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "sim/core/temporary_folder.h"
#include "sim/recording/replay.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"
#include "tests/bindings/interface.h"

namespace griffith::testing {
namespace {

std::string value_of(const griffith_scene* scene, const char* pointer) {
  char* json = nullptr;
  griffith_error error;
  EXPECT_EQ(griffith_scene_get(scene, pointer, &json, &error), GRIFFITH_OK) << error.problem;
  const std::string text = json ? json : "";
  griffith_string_free(json);
  return text;
}

TEST(CScenes, FieldsAreSetByPointer) {
  const OwnedScene scene = parse_scene(kShotWall);
  EXPECT_EQ(value_of(scene.get(), "/projectiles/0/speed"), "40");
  ASSERT_EQ(griffith_scene_set(scene.get(), "/projectiles/0/speed", "12.5", nullptr), GRIFFITH_OK);
  EXPECT_EQ(value_of(scene.get(), "/projectiles/0/speed"), "12.5");
  ASSERT_EQ(griffith_scene_set(scene.get(), "bodies/0/material", "\"granite\"", nullptr), GRIFFITH_OK);
  EXPECT_EQ(value_of(scene.get(), "/bodies/0/material/density"), "2650");
}

TEST(CScenes, AWrongValueNamesItsPlaceAndChangesNothing) {
  const OwnedScene scene = parse_scene(kShotWall);
  const std::string before = value_of(scene.get(), "");
  griffith_error error;
  EXPECT_EQ(griffith_scene_set(scene.get(), "/bodies/0/material/density", "-1", &error), GRIFFITH_INPUT_ERROR);
  EXPECT_STREQ(error.where, "scene#/bodies/0/material/density");
  EXPECT_STRNE(error.problem, "");
  EXPECT_STRNE(error.remedy, "");
  EXPECT_EQ(griffith_scene_set(scene.get(), "/bodies/7/name", "\"x\"", &error), GRIFFITH_INPUT_ERROR);
  EXPECT_EQ(griffith_scene_set(scene.get(), "/gravity", "no JSON", &error), GRIFFITH_INPUT_ERROR);
  EXPECT_EQ(value_of(scene.get(), ""), before);
}

TEST(CScenes, LongTextsOfErrorsAreCutBetweenCharacters) {
  const std::string path = "/" + [] {
    std::string text;
    for (int i = 0; i < 400; ++i) text += "ä";
    return text;
  }();
  griffith_scene* scene = nullptr;
  griffith_error error;
  EXPECT_EQ(griffith_scene_read(path.c_str(), &scene, &error), GRIFFITH_INPUT_ERROR);
  const std::string where = error.where;
  ASSERT_LT(where.size(), sizeof error.where);
  EXPECT_TRUE(where.ends_with("ä…")) << where;
}

TEST(CScenes, AMeshOfArraysStandsForAFile) {
  const OwnedScene scene = parse_scene(
      R"({"version": 1, "bodies": [{"shape": {"mesh": {"path": "tet"}}, "position": [0, 1, 0], "material": "brick"}]})");
  const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::int32_t tets[] = {0, 1, 2, 3};
  ASSERT_EQ(griffith_scene_set_mesh(scene.get(), "tet", points, 4, tets, 1, nullptr), GRIFFITH_OK);
  griffith_world* made = nullptr;
  griffith_error error;
  ASSERT_EQ(griffith_world_create(scene.get(), nullptr, &made, &error), GRIFFITH_OK) << error.where << error.problem;
  const OwnedWorld world(made);
  double mass = 0;
  ASSERT_EQ(griffith_world_value(made, "mass", &mass, nullptr), GRIFFITH_OK);
  EXPECT_NEAR(mass, 1900.0 / 6, 1e-9 * mass);
  const std::int32_t outside[] = {0, 1, 2, 4};
  EXPECT_EQ(griffith_scene_set_mesh(scene.get(), "tet", points, 4, outside, 1, &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_STREQ(error.where, "tets");
}

TEST(CWorlds, GiveTheHashOfTheLibrary) {
  World world(scene_from_json(kShotWall));
  for (int step = 0; step < 30; ++step) world.step();
  EXPECT_EQ(griffith_world_state_hash(shot_wall(30).get()), world.state_hash());
}

TEST(CWorlds, CopiesGoOnAlike) {
  const OwnedWorld world = shot_wall(5);
  griffith_world* made = nullptr;
  ASSERT_EQ(griffith_world_copy(world.get(), &made, nullptr), GRIFFITH_OK);
  const OwnedWorld copy(made);
  ASSERT_EQ(griffith_world_step(world.get(), 20, nullptr), GRIFFITH_OK);
  const std::uint64_t after = griffith_world_state_hash(world.get());
  ASSERT_EQ(griffith_world_restore(world.get(), copy.get(), nullptr), GRIFFITH_OK);
  EXPECT_NE(griffith_world_state_hash(world.get()), after);
  ASSERT_EQ(griffith_world_step(world.get(), 20, nullptr), GRIFFITH_OK);
  EXPECT_EQ(griffith_world_state_hash(world.get()), after);
}

TEST(CWorlds, RecordingsAreMadeAgain) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "run.tar.zst").string();
  const OwnedWorld world = make_world(kShotWall);
  ASSERT_EQ(griffith_world_start_recording(world.get(), nullptr), GRIFFITH_OK);
  const griffith_shot shot = {{0, 1, 3}, {0, 0, -1}, 20, 10, 0.1};
  ASSERT_EQ(griffith_world_step(world.get(), 3, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_fire(world.get(), &shot, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_set_material(world.get(), 0, "young_modulus", "5e9", nullptr), GRIFFITH_OK);
  const double place[] = {0, 1, 1}, impulse[] = {0, 0, -50}, target[] = {0, 1.2, 1};
  ASSERT_EQ(griffith_world_push(world.get(), place, impulse, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_grab(world.get(), place, target, nullptr, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_step(world.get(), 6, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_move_grab(world.get(), place, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_step(world.get(), 3, nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_release(world.get(), nullptr), GRIFFITH_OK);
  ASSERT_EQ(griffith_world_step(world.get(), 3, nullptr), GRIFFITH_OK);
  griffith_error error;
  ASSERT_EQ(griffith_world_save_recording(world.get(), path.c_str(), &error), GRIFFITH_OK) << error.problem;
  const Recording recording = read_recording(path);
  Replay replay(recording);
  while (!replay.at_end()) replay.advance();
  EXPECT_FALSE(replay.difference());
  EXPECT_EQ(replay.world().state_hash(), griffith_world_state_hash(world.get()));
}

/// A free block of 1 m and 1000 kg without gravity, in the middle of the world.
OwnedWorld floating_block() {
  return make_world(R"({"version": 1, "gravity": [0, 0, 0], "ground": null, "simulation": {"fracture": false},
      "bodies": [{"shape": {"box": {"size": [1, 1, 1], "element_size": 0.5}},
                  "material": {"density": 1000, "young_modulus": 1e9}}]})");
}

double value_of(const OwnedWorld& world, const char* name) {
  double value = 0;
  EXPECT_EQ(griffith_world_value(world.get(), name, &value, nullptr), GRIFFITH_OK);
  return value;
}

TEST(CWorlds, APushFromOutsideActsOnTheNearestPoint) {
  const double outside[] = {9, 0.1, 0}, inside[] = {0.2, 0.1, 0.1}, impulse[] = {-3, 0, 0};
  for (const double* place : {outside, inside}) {
    const OwnedWorld world = floating_block();
    ASSERT_EQ(griffith_world_push(world.get(), place, impulse, nullptr), GRIFFITH_OK);
    ASSERT_EQ(griffith_world_step(world.get(), 2, nullptr), GRIFFITH_OK);
    EXPECT_NEAR(value_of(world, "momentum_x"), -3, 1e-9);
    EXPECT_NEAR(value_of(world, "angular_momentum_z"), 0.3, 1e-3) << "0.1 m · 3 N·s";
  }
}

TEST(CWorlds, PushesAndGrabsHaveRanges) {
  const OwnedWorld world = floating_block();
  const double fine[] = {0, 0, 0}, far[] = {2e6, 0, 0}, strong[] = {0, 1e10, 0};
  const griffith_spring loose = {0, 0.7, 10};
  griffith_error error;
  EXPECT_EQ(griffith_world_push(world.get(), far, fine, &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_STREQ(error.where, "position");
  EXPECT_EQ(griffith_world_push(world.get(), fine, strong, &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_STREQ(error.where, "impulse");
  EXPECT_EQ(griffith_world_push(world.get(), fine, nullptr, &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_EQ(griffith_world_grab(world.get(), fine, fine, &loose, &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_STREQ(error.where, "spring.frequency");
  EXPECT_EQ(griffith_world_move_grab(world.get(), fine, &error), GRIFFITH_INPUT_ERROR) << "nothing is held";
  EXPECT_EQ(griffith_world_release(world.get(), &error), GRIFFITH_OK);
}

TEST(CWorlds, ShotsHaveTheRangesOfScenes) {
  const OwnedWorld world = make_world(kShotWall);
  const griffith_shot shot = {{0, 1, 3}, {0, 0, -1}, 20, 10, 0.1};
  const auto problem_place = [&](const auto& change) -> std::string {
    griffith_shot wrong = shot;
    change(wrong);
    griffith_error error;
    EXPECT_EQ(griffith_world_fire(world.get(), &wrong, &error), GRIFFITH_INVALID_ARGUMENT);
    return error.where;
  };
  EXPECT_EQ(problem_place([](griffith_shot& s) { s.radius = 1e300; }), "shot.radius");
  EXPECT_EQ(problem_place([](griffith_shot& s) { s.mass = 1e-7; }), "shot.mass");
  EXPECT_EQ(problem_place([](griffith_shot& s) { s.speed = 2e5; }), "shot.speed");
  EXPECT_EQ(problem_place([](griffith_shot& s) { s.position[1] = -2e6; }), "shot.position");
  EXPECT_EQ(problem_place([](griffith_shot& s) { s.direction[2] = std::nan(""); }), "shot.direction");
  EXPECT_EQ(griffith_world_fire(world.get(), &shot, nullptr), GRIFFITH_OK);
}

TEST(CWorlds, ARecordingMissesNothing) {
  const OwnedWorld world = make_world(kShotWall);
  const griffith_shot shot = {{0, 1, 3}, {0, 0, -1}, 20, 10, 0.1};
  ASSERT_EQ(griffith_world_fire(world.get(), &shot, nullptr), GRIFFITH_OK);
  griffith_error error;
  EXPECT_EQ(griffith_world_start_recording(world.get(), &error), GRIFFITH_INVALID_ARGUMENT);
  EXPECT_EQ(griffith_world_save_recording(world.get(), "run.tar.zst", &error), GRIFFITH_INVALID_ARGUMENT);
}

TEST(CWorlds, BuildingCanBeCancelled) {
  const griffith_monitor monitor = {nullptr, [](void*) -> std::int32_t { return 1; }, nullptr};
  const OwnedScene scene = parse_scene(R"({"version": 1, "bodies": [
      {"shape": {"sphere": {"radius": 1, "element_size": 0.1}}, "position": [0, 1, 0]}]})");
  griffith_world* world = nullptr;
  EXPECT_EQ(griffith_world_create(scene.get(), &monitor, &world, nullptr), GRIFFITH_CANCELLED);
  EXPECT_FALSE(world);
}

/// Bytes that are allocated.
std::size_t allocated() { return mallinfo2().uordblks; }

TEST(CWorlds, AThousandLeaveNothingBehind) {
  const OwnedScene scene = parse_scene(kShotWall);
  const auto make_and_drop = [&] {
    griffith_world* world = nullptr;
    ASSERT_EQ(griffith_world_create(scene.get(), nullptr, &world, nullptr), GRIFFITH_OK);
    ASSERT_EQ(griffith_world_step(world, 2, nullptr), GRIFFITH_OK);
    griffith_world_destroy(world);
  };
  for (int i = 0; i < 20; ++i) make_and_drop();
  const std::size_t before = allocated();
  for (int i = 0; i < 1000; ++i) make_and_drop();
  const std::size_t after = allocated();
  EXPECT_LT(after, before + 200'000);  // a world of this scene holds some 300 kB
}

}  // namespace
}  // namespace griffith::testing
