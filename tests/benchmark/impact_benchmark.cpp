// What the steps cost in which many bodies strike each other: 1,000 breakable concrete bricks that fall into a heap.
// Counters: processor time of the longest step and of the mean one [ms], cracks, impacts that were followed, pieces at
// the end.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <string>

#include "sim/core/parallel.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// 10 × 10 bricks in ten layers, each turned its own way.
Scene landing_bricks() {
  Scene scene;
  scene.simulation.time_step = 1.0 / 60;
  for (int i = 0; i < 1000; ++i) {
    BodyDescription& brick = scene.bodies.emplace_back();
    brick.name = "brick " + std::to_string(i);
    brick.shape = BoxShape{Vec3(0.12, 0.08, 0.1), Vec3(0.12, 0.08, 0.1), BoxPattern::five_tet};
    brick.material = *find_material_preset("concrete");
    brick.position = Vec3(0.17 * (i % 10 - 4.5), 0.2 + 0.17 * (i / 100), 0.17 * (i / 10 % 10 - 4.5));
    brick.rotation_degrees = Vec3(37 * i % 60 - 30, 53 * i % 90 - 45, 71 * i % 60 - 30);
  }
  return scene;
}

double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void bricks_landing(benchmark::State& state) {
  constexpr int kSteps = 60;
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  double longest = 0, sum = 0;
  int cracks = 0, impacts = 0;
  for (auto _ : state) {
    World world(landing_bricks());
    for (int step = 0; step < kSteps; ++step) {
      const double start = processor_milliseconds();
      world.step();
      const double time = processor_milliseconds() - start;
      longest = std::max(longest, time);
      sum += time;
      cracks += world.frame().report.cracks;
      impacts += world.frame().report.impacts;
    }
    state.counters["pieces"] = static_cast<double>(world.frame().bodies.size());
  }
  state.counters["longest_ms"] = longest;
  state.counters["mean_ms"] = sum / kSteps / static_cast<double>(state.iterations());
  state.counters["cracks"] = cracks;
  state.counters["impacts"] = impacts;
}
BENCHMARK(bricks_landing)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

}  // namespace
}  // namespace griffith
