#include "sim/scene/scene_difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "sim/core/error.h"

namespace griffith {
namespace {

using ::testing::ElementsAre;

Scene two_bodies() {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "left";
  scene.bodies[1].name = "right";
  scene.bodies[1].supports = {{BoxRegion{Vec3(-1, -1, -1), Vec3(1, -0.5, 1)}}};
  scene.projectiles.resize(1);
  return scene;
}

TEST(SceneDifference, SettingsMakeTheOneSceneTheOther) {
  const std::vector<std::function<void(Scene&)>> edits = {
      [](Scene& scene) { scene.bodies[0].material.young_modulus *= 2; },
      [](Scene& scene) { scene.bodies[1].position = Vec3(0.1, 2, 1e-9); },
      [](Scene& scene) { scene.bodies[1].shape = SphereShape{}; },
      [](Scene& scene) { scene.bodies.pop_back(); },
      [](Scene& scene) { scene.ground.reset(); },
      [](Scene& scene) { scene.name = "a/b~c \"d\" \\ e"; },
      [](Scene& scene) { scene.materials = {scene.bodies[0].material}, scene.materials[0].name = "of/my own"; },
      [](Scene& scene) { scene.view.layers = {ViewLayer::supports}, scene.view.edges = !scene.view.edges; },
      [](Scene& scene) { scene.projectiles[0].speed = 3, scene.gravity.x() = 1, scene.probes.resize(1); }};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Scene before = two_bodies();
    Scene after = before;
    edits[i](after);
    EXPECT_TRUE(with_settings(before, settings_between(before, after), "test") == after) << i;
    EXPECT_TRUE(with_settings(after, settings_between(after, before), "test") == before) << i << " and back";
  }
}

TEST(SceneDifference, ASettingIsAsDeepAsItCanBe) {
  const Scene before = two_bodies();
  EXPECT_TRUE(settings_between(before, before).empty());
  Scene after = before;
  after.bodies[1].position.y() = 2;
  after.projectiles[0].speed = 12.5;
  EXPECT_THAT(settings_between(before, after),
              ElementsAre(SceneSetting{"/bodies/1/position", "[0,2,0]"}, SceneSetting{"/projectiles/0/speed", "12.5"}));
}

TEST(SceneDifference, WhatASceneCannotHaveIsNamed) {
  const std::vector<SceneSetting> nowhere = {{"/bodies/7/name", "\"x\""}}, wrong = {{"/gravity", "\"down\""}};
  for (const std::vector<SceneSetting>& settings : {nowhere, wrong}) {
    try {
      with_settings(two_bodies(), settings, "my.script:3");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_TRUE(error.where().starts_with("my.script:3")) << error.where();
    }
  }
}

std::vector<FieldChange> changes(const Scene& before, const Scene& after) {
  return field_changes(full_scene_text(before), full_scene_text(after));
}

TEST(FieldChanges, NameEachFieldWithBothValues) {
  const Scene before = two_bodies();
  EXPECT_TRUE(changes(before, before).empty());
  Scene after = before;
  after.bodies[1].position = Vec3(1, 2, 3);
  after.bodies[1].shape = SphereShape{.radius = 0.5};
  after.projectiles[0].speed = 12.5;
  std::map<std::string, FieldChange> found;
  for (const FieldChange& change : changes(before, after)) found[change.pointer] = change;
  EXPECT_EQ(found.at("/bodies/1/position").before, "[0,0,0]");
  EXPECT_EQ(found.at("/bodies/1/position").after, "[1,2,3]");
  EXPECT_EQ(found.at("/projectiles/0/speed").after, "12.5");
  EXPECT_FALSE(found.at("/bodies/1/shape/box").after);
  EXPECT_FALSE(found.at("/bodies/1/shape/sphere").before);
  EXPECT_EQ(found.size(), 4u);
}

/// A body that is taken out, put in or moved in the list is no change of the others.
TEST(FieldChanges, NamedItemsAreComparedByName) {
  const Scene before = two_bodies();
  Scene after = before;
  after.bodies.erase(after.bodies.begin());
  const auto removed = changes(before, after);
  ASSERT_EQ(removed.size(), 1u);
  EXPECT_EQ(removed[0].pointer, "/bodies/0");
  EXPECT_FALSE(removed[0].after);
  const auto added = changes(after, before);
  ASSERT_EQ(added.size(), 1u);
  EXPECT_FALSE(added[0].before);
  after = before;
  std::swap(after.bodies[0], after.bodies[1]);
  EXPECT_TRUE(changes(before, after).empty());
}

TEST(FieldChanges, AFieldThatAnOlderProgramDidNotHaveIsNew) {
  const std::vector<FieldChange> found = field_changes(R"({"a": {"b": 1}})", R"({"a": {"b": 1, "c": [1, 2]}})");
  EXPECT_THAT(found, ElementsAre(FieldChange{"/a/c", std::nullopt, "[1,2]"}));
  EXPECT_THROW(field_changes("{", "{}"), InputError);
}

}  // namespace
}  // namespace griffith
