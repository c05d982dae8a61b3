// The energy account of the sample scenes.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"
#include "tests/world/measures.h"

namespace griffith {
namespace {

constexpr double kTolerance = 0.01;

/// Returns the largest number of steps to follow a scene.
int steps_of(const std::string& scene) {
  const bool is_struck_early = scene == "vase_shot" || scene == "glass_pane" || scene == "window" ||
                               scene == "bear_shot" || scene == "tempered_pane";
  return is_struck_early ? 16 : 48;
}

/// Makes up to `steps` steps, and eight after the first crack at most.
void follow(World& world, int steps) {
  for (int broken = 0; steps > 0 && broken < 8; --steps) {
    world.step();
    broken += !world.frame().crack_events.empty();
  }
}

TEST(EnergyAccount, EverySceneCloses) {
  int scenes = 0, cracked = 0;
  for (const auto& file : std::filesystem::directory_iterator(GRIFFITH_SOURCE_DIR "/scenes")) {
    if (file.path().extension() != ".json" || file.path().stem() == "scene.schema") continue;
    ++scenes;
    for (const Integrator integrator : {Integrator::implicit, Integrator::hybrid}) {
      Scene scene = read_scene(file.path());
      scene.simulation.integrator = integrator;
      World world(scene);
      const int steps = scene.analysis == Analysis::static_ ? 1 : steps_of(file.path().stem());
      follow(world, steps);
      const Frame frame = world.frame();
      EXPECT_GT(frame.energy.turned_over(), 0) << file.path();
      EXPECT_LT(testing::fraction_unaccounted(frame.energy), kTolerance) << file.path();
      // Implicit steps take from one of these what they give to the other; overlaps of bodies at rest go at some work.
      constexpr double kOverlaps = 0.1;  // [J]
      EXPECT_GT(frame.energy.contacts + frame.energy.time_integration,
                -kTolerance * frame.energy.turned_over() - kOverlaps)
          << file.path() << ": contacts add energy";
      cracked += integrator == Integrator::hybrid && !frame.crack_events.empty();
    }
  }
  EXPECT_GE(scenes, 20);
  EXPECT_GE(cracked, 0.6 * scenes) << "most were followed until they broke";
}

}  // namespace
}  // namespace griffith
