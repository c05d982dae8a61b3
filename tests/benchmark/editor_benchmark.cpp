// Work of the editor itself for a step with 54,080 deformable tets. On the window's thread: follow_step, upload,
// panels; on a background thread after the step: hashes, make_picture. Drawing is separate: on software GL it takes
// more than all of this.
#include <benchmark/benchmark.h>
#include <imgui.h>

#include <chrono>
#include <optional>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/imgui_context_owner.h"
#include "app/editor/step_picture.h"
#include "renderer/egl_context.h"
#include "renderer/surface_pass.h"
#include "renderer/target.h"
#include "sim/scene/scene_reader.h"

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

/// Measures the work of the window's thread for a step in the background, without drawing and panels: handling of the
/// last one, and a copy of the world for the next. Sleep takes no processor time.
void follow_step(benchmark::State& state) {
  const render::EglContext context(std::nullopt);
  Editor editor(swaying_wall(), "");
  editor.run().step_in_background();
  editor.state().running = true;
  for (auto _ : state) {
    const std::int64_t step = editor.run().frame().step;
    while (editor.run().frame().step == step) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      editor.run().advance(1.0 / 60);
    }
  }
}
BENCHMARK(follow_step)->Unit(benchmark::kMillisecond);

/// Measures the hashes of a step for the timeline.
void hashes(benchmark::State& state) {
  const World world = swinging_world();
  for (auto _ : state) benchmark::DoNotOptimize(world.state_hashes());
}
BENCHMARK(hashes)->Unit(benchmark::kMillisecond);

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

StepPicture picture_of(const World& world) {
  const Scene scene = swaying_wall();
  return {{scene, scene.view, {}, {}}, CopyOnWrite(embedded_display(world.frame(), scene)), {}};
}

/// The picture of a step, by stress, before it is drawn.
void make_picture(benchmark::State& state) {
  const World world = swinging_world();
  const StepPicture before = picture_of(world);
  for (auto _ : state) {
    StepPicture picture = before;
    picture.draw(world.frame());
    benchmark::DoNotOptimize(picture);
  }
}
BENCHMARK(make_picture)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// That picture's way to the graphics device.
void upload(benchmark::State& state) {
  const World world = swinging_world();
  StepPicture picture = picture_of(world);
  picture.draw(world.frame());
  const render::EglContext context(std::nullopt);
  render::SurfacePass pass;
  for (auto _ : state) pass.upload(picture.drawn.surface);
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
    editor.run().step();
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
