// What the editor itself does in a frame while 54,080 tets sway: copies of the world for steps in the background, the
// picture and its way to the graphics device, panels. Drawing is apart: on software GL it takes more than all of this.
#include <benchmark/benchmark.h>
#include <imgui.h>

#include <optional>

#include "app/editor/editor.h"
#include "app/editor/imgui_context_owner.h"
#include "app/picture/draw_scene_from_frame.h"
#include "renderer/egl_context.h"
#include "renderer/surface_pass.h"
#include "renderer/target.h"
#include "sim/scene/scene_reader.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {
namespace {

constexpr int kWidth = 1500, kHeight = 940;

Scene swaying_wall() {
  Scene scene = read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes/validation/swaying_wall.json");
  std::get<BoxShape>(scene.bodies[0].shape).element_size = Vec3(0.0384, 0.0384, 0.0625);
  return scene;
}

World swinging_world() {
  World world(swaying_wall());
  for (int i = 0; i < 10; ++i) world.step();
  return world;
}

void copy_world(benchmark::State& state) {
  const World world = swinging_world();
  for (auto _ : state) benchmark::DoNotOptimize(World(world));
}
BENCHMARK(copy_world)->Unit(benchmark::kMillisecond);

/// What the window's thread does for a step in the background, but for its panels: a copy before, and hashes, marks
/// and now and then a copy for the way back after it.
void follow_step(benchmark::State& state) {
  Timeline timeline(swinging_world());
  for (auto _ : state) {
    World next = timeline.before_step();
    state.PauseTiming();
    next.step();
    state.ResumeTiming();
    timeline.take_step(std::move(next));
  }
}
BENCHMARK(follow_step)->Unit(benchmark::kMillisecond);

/// A step, of the world itself or of a copy of it: what they share is copied as it changes.
void step(benchmark::State& state, bool of_copy) {
  World world = swinging_world();
  for (auto _ : state) {
    const std::optional<World> shown = of_copy ? std::optional(world) : std::nullopt;
    world.step();
  }
}
BENCHMARK_CAPTURE(step, of_world, false)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(step, of_copy, true)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// The picture of a frame, by stress, before it is drawn.
void make_picture(benchmark::State& state) {
  const Scene scene = swaying_wall();
  const World world = swinging_world();
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  for (auto _ : state) benchmark::DoNotOptimize(draw_scene_from_frame(world.frame(), display, scene, scene.view, {}));
}
BENCHMARK(make_picture)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// That picture's way to the graphics device.
void upload(benchmark::State& state) {
  const Scene scene = swaying_wall();
  const World world = swinging_world();
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, scene.view, {});
  const render::EglContext context(std::nullopt);
  render::SurfacePass pass;
  for (auto _ : state) pass.upload(drawn.surface);
}
BENCHMARK(upload)->Unit(benchmark::kMillisecond);

/// The panels after each step, up to what ImGui hands to the graphics device.
void panels(benchmark::State& state) {
  const render::EglContext context(std::nullopt);
  ImGuiContextOwner imgui(1);
  const render::Target target(kWidth, kHeight, 1);
  Editor editor(swaying_wall(), "");
  for (auto _ : state) {
    state.PauseTiming();
    editor.step();
    editor.draw_picture(1);
    imgui.begin_frame(kWidth, kHeight);
    state.ResumeTiming();
    editor.draw_panels(imgui.fonts());
    ImGui::Render();
    state.PauseTiming();
    target.bind();
    imgui.end_frame();
    state.ResumeTiming();
  }
}
BENCHMARK(panels)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace griffith::app
