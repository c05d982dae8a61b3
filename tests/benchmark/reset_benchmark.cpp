// What it costs to start a scene again, as the editor's Reset does: the old world goes, a new one is built and prepared
// for drawing. 4,000 blocks from the scene file, and a slab that has broken into more than 4,000 pieces; and the first
// step after, compared with a later one.

#include <benchmark/benchmark.h>

#include <optional>

#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/embedded_picture.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// 20 × 10 × 20 blocks of five tets, a block's width apart.
Scene blocks() {
  Scene scene;
  for (int i = 0; i < 4000; ++i) {
    BodyDescription& block = scene.bodies.emplace_back();
    block.shape = BoxShape{Vec3::Constant(0.2), Vec3::Constant(0.2), BoxPattern::five_tet};
    block.position = 0.4 * Vec3(i % 20, i / 400 + 1, i / 20 % 20);
    block.rotation_degrees.y() = i;
  }
  return scene;
}

/// A slab of weak brick that spins so fast that it flies apart.
Scene slab() {
  Scene scene;
  BodyDescription& body = scene.bodies.emplace_back();
  body.shape = BoxShape{Vec3(4, 0.8, 4), Vec3::Constant(0.2), BoxPattern::kuhn};
  body.position.y() = 0.6;
  body.angular_velocity.y() = 20;
  body.material.young_modulus = 1e6;
  body.material.tensile_strength = 1e4;
  body.material.fracture_toughness = 1e4;
  scene.simulation.max_cracks_per_step = 1000000;
  return scene;
}

World broken_slab() {
  World world(slab());
  for (int step = 0; step < 15 && world.frame().fragments < 4000; ++step) world.step();
  return world;
}

/// Resets as the editor does.
void reset(World& world, const Scene& scene) {
  world = World(scene);
  const app::EmbeddedDisplay display = app::embedded_display(world.frame(), scene);
  benchmark::DoNotOptimize(app::draw_scene_from_frame(world.frame(), display, scene, scene.view, {}));
}

void reset_blocks(benchmark::State& state) {
  const Scene scene = blocks();
  World world(scene);
  for (auto _ : state) reset(world, scene);
}
BENCHMARK(reset_blocks)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void reset_broken(benchmark::State& state) {
  const Scene scene = slab();
  std::optional<World> world;
  for (auto _ : state) {
    state.PauseTiming();
    world.reset();
    world = broken_slab();
    state.counters["pieces"] = static_cast<double>(world->frame().bodies.size());
    state.ResumeTiming();
    reset(*world, scene);
  }
}
BENCHMARK(reset_broken)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(3);

/// The step after `state.range(0)` others.
void step_blocks(benchmark::State& state) {
  const Scene scene = blocks();
  std::optional<World> world;
  for (auto _ : state) {
    state.PauseTiming();
    world.emplace(scene);
    for (int i = 0; i < state.range(0); ++i) world->step();
    state.ResumeTiming();
    world->step();
  }
}
BENCHMARK(step_blocks)->Arg(0)->Arg(1)->Arg(5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(5);

}  // namespace
}  // namespace griffith
