#pragma once

#include <griffith/griffith.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace griffith::testing {

struct Destroy {
  void operator()(griffith_scene* scene) const { griffith_scene_destroy(scene); }
  void operator()(griffith_world* world) const { griffith_world_destroy(world); }
};
using OwnedScene = std::unique_ptr<griffith_scene, Destroy>;
using OwnedWorld = std::unique_ptr<griffith_world, Destroy>;

inline OwnedScene parse_scene(const std::string& json) {
  griffith_scene* scene = nullptr;
  griffith_error error;
  EXPECT_EQ(griffith_scene_parse(json.c_str(), nullptr, &scene, &error), GRIFFITH_OK) << error.where << error.problem;
  return OwnedScene(scene);
}

inline OwnedWorld make_world(const std::string& json) {
  griffith_world* world = nullptr;
  griffith_error error;
  EXPECT_EQ(griffith_world_create(parse_scene(json).get(), nullptr, &world, &error), GRIFFITH_OK) << error.problem;
  return OwnedWorld(world);
}

/// A wall of 24 tetrahedra and a ball that breaks it.
inline constexpr char kShotWall[] = R"({"version": 1, "bodies": [
    {"shape": {"box": {"size": [3, 3, 1], "element_size": 1.5, "pattern": "kuhn"}}, "position": [0, 1.5, 0],
     "material": {"preset": "brick", "tensile_strength": 60000, "fracture_toughness": 40000},
     "supports": [{"region": {"half_space": {"point": [0, -1.5, 0], "normal": [0, -1, 0]}}}]}],
    "projectiles": [{"position": [0, 2, 2], "speed": 40, "mass": 25}]})";

/// That wall after some steps.
inline OwnedWorld shot_wall(int steps) {
  OwnedWorld world = make_world(kShotWall);
  EXPECT_EQ(griffith_world_step(world.get(), steps, nullptr), GRIFFITH_OK);
  return world;
}

}  // namespace griffith::testing
