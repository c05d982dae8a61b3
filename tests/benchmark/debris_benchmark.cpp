// What the steps of much debris cost: a wall of 432 tetrahedra that splits to dust, and 1,000 bricks that fall into a
// pile and come to rest. Counters: the longest step and the mean one [ms], steps above 16 and 30 ms, pieces at the end.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "sim/world/world.h"

namespace griffith {
namespace {

Scene weak_wall() {
  Scene scene;
  BodyDescription& wall = scene.bodies.emplace_back();
  wall.shape = BoxShape{Vec3(12, 12, 1), Vec3(1.334, 1.5, 1), BoxPattern::kuhn};
  wall.position = Vec3(0, 6, 0);
  wall.material.tensile_strength = 6e3;
  wall.material.fracture_toughness = 1.8e4;
  wall.supports = {{HalfSpaceRegion{Vec3(0, -6, 0), -Vec3::UnitY()}}};
  ProjectileBurst shots;
  shots.count = 3;
  shots.interval = 0.25;
  shots.start = 0.1;
  shots.position = Vec3(0, 7, 8.5);
  scene.projectiles = {shots};
  return scene;
}

/// 10 × 10 bricks in ten layers, each turned its own way.
Scene falling_bricks() {
  Scene scene;
  for (int i = 0; i < 1000; ++i) {
    BodyDescription& brick = scene.bodies.emplace_back();
    brick.shape = BoxShape{Vec3(0.12, 0.08, 0.1), Vec3(0.12, 0.08, 0.1), BoxPattern::five_tet};
    brick.position = Vec3(0.17 * (i % 10 - 4.5), 0.2 + 0.17 * (i / 100), 0.17 * (i / 10 % 10 - 4.5));
    brick.rotation_degrees = Vec3(37 * i % 60 - 30, 53 * i % 90 - 45, 71 * i % 60 - 30);
  }
  return scene;
}

void run(benchmark::State& state, const Scene& scene, int steps) {
  using Clock = std::chrono::steady_clock;
  double longest = 0, sum = 0;
  int above_16 = 0, above_30 = 0;
  for (auto _ : state) {
    World world(scene);
    for (int step = 0; step < steps; ++step) {
      const Clock::time_point start = Clock::now();
      world.step();
      const double time = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      longest = std::max(longest, time);
      sum += time;
      above_16 += time > 16;
      above_30 += time > 30;
    }
    state.counters["pieces"] = static_cast<double>(world.frame().bodies.size());
  }
  state.counters["longest_ms"] = longest;
  state.counters["mean_ms"] = sum / steps / static_cast<double>(state.iterations());
  state.counters["above_16_ms"] = above_16;
  state.counters["above_30_ms"] = above_30;
}

void wall_to_dust(benchmark::State& state) { run(state, weak_wall(), 300); }
BENCHMARK(wall_to_dust)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

void pile_of_bricks(benchmark::State& state) { run(state, falling_bricks(), 600); }
BENCHMARK(pile_of_bricks)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace griffith
