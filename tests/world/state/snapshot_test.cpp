#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

std::vector<std::string> scene_files() {
  std::vector<std::string> files;
  for (const char* folder : {"/scenes", "/scenes/validation"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(GRIFFITH_SOURCE_DIR) + folder))
      if (entry.path().extension() == ".json" && entry.path().stem().extension().empty())
        files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

/// Acts as a user at some steps: fires, and changes the material.
void act(World& world, const Scene& scene, int step) {
  if (step % 16 == 5) {
    ProjectileBurst burst;
    burst.position = scene.bodies[0].position + Vec3(0, 0.2, 3);
    burst.speed = 15;
    world.fire(burst);
  }
  if (step == 29) {
    Material material = scene.bodies[0].material;
    material.young_modulus *= 0.9;
    world.set_material(0, material);
  }
}

/// State of a world after a step, to the bit.
struct Shown {
  StateHashes hashes;
  std::size_t cracks, bodies, contacts;
  double stored, lost, broke_scaled;
  bool operator==(const Shown&) const = default;
};

/// Sum of the scale factors at which bodies broke.
double factors_of_broken(const Frame& frame) {
  double sum = 0;
  for (const BodyView& body : frame.bodies) sum += body.broke_scaled ? body.broke_scaled->factor : 0;
  return sum;
}

Shown shown_by(const World& world) {
  const Frame frame = world.frame();
  return {world.state_hashes(),  frame.crack_events.size(), frame.bodies.size(),     frame.contacts.size(),
          frame.energy.stored(), frame.energy.lost(),       factors_of_broken(frame)};
}

std::vector<Shown> shown_until(World& world, const Scene& scene, int first, int last) {
  std::vector<Shown> seen;
  for (int step = first; step < last; ++step) {
    act(world, scene, step);
    world.step();
    seen.push_back(shown_by(world));
  }
  return seen;
}

class Snapshot : public ::testing::TestWithParam<std::string> {};

TEST_P(Snapshot, ACopyOfTheWorldGoesOnAsTheWorldDid) {
  const Scene scene = read_scene(GetParam());
  std::mt19937 random(std::hash<std::string>()(scene.name));
  World world(scene);
  int step = 0;
  std::vector<Shown> seen;
  for (int count = 0; count < 2; ++count) {
    const int taken = std::uniform_int_distribution(step, step + 8)(random);
    shown_until(world, scene, step, taken);
    const World snapshot = world;
    const int end = taken + 4;
    const std::vector<Shown> first = shown_until(world, scene, taken, end);
    World restored = snapshot;
    EXPECT_EQ(restored.state_hash(), snapshot.state_hash());
    const std::vector<Shown> again = shown_until(restored, scene, taken, end);
    for (int i = 0; i < end - taken; ++i)
      ASSERT_EQ(first[i], again[i]) << "copied after step " << taken << ", differs after " << taken + i + 1;
    step = end;
  }
}

TEST(SnapshotViews, ShowTheCopysOwnBodies) {
  const Scene scene = read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/wall_small.json");
  auto world = std::make_unique<World>(scene);
  for (int step = 0; step < 40; ++step) world->step();
  const World copy = *world;
  const Frame first = world->frame(), second = copy.frame();
  for (std::size_t i = 0; i < first.bodies.size(); ++i) {
    const auto &parts = first.bodies[i].collision_parts, &copied = second.bodies[i].collision_parts;
    ASSERT_FALSE(parts.empty());
    EXPECT_NE(parts.data(), copied.data());
    EXPECT_TRUE(std::ranges::equal(parts, copied));
  }
}

/// Contacts among sleepers, which nobody looks at, are part of a copy: it shows when they wake.
TEST(SleepingSnapshot, WakesAsTheWorldDoes) {
  for (const char* name : {"block_stack", "walls_4"}) {
    const Scene scene = read_scene(std::string(GRIFFITH_SOURCE_DIR) + "/scenes/" + name + ".json");
    World world(scene);
    while (world.frame().report.sleeping_bodies < 3 && world.frame().step < 600) world.step();
    ASSERT_GE(world.frame().report.sleeping_bodies, 3) << name;
    World copy = world;
    const World copy_of_copy = copy;
    const int step = static_cast<int>(world.frame().step);
    ProjectileBurst burst;
    burst.position = scene.bodies[0].position + Vec3(0.05, 0, 2);
    burst.speed = 12;
    world.fire(burst), copy.fire(burst);
    const std::vector<Shown> first = shown_until(world, scene, step, step + 40);
    EXPECT_EQ(shown_until(copy, scene, step, step + 40), first) << name;
    EXPECT_GT(world.frame().contacts.size(), 0u) << name;
    copy = copy_of_copy;
    copy.fire(burst);
    EXPECT_EQ(shown_until(copy, scene, step, step + 40), first) << name;
  }
}

std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
  const std::filesystem::path path(info.param);
  return path.parent_path().stem().string() + "_" + path.stem().string();
}

INSTANTIATE_TEST_SUITE_P(Scenes, Snapshot, ::testing::ValuesIn(scene_files()), name_of);

}  // namespace
}  // namespace griffith
