// Cost for the renderer of a picture of 1280×720 in natural colors, some time after the impact; and of one of a plate
// of 100,000 triangles. LP_NUM_THREADS=0 keeps software GL on one thread.
#include <benchmark/benchmark.h>

#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "renderer/egl_context.h"
#include "renderer/renderer.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

constexpr int kWidth = 1280, kHeight = 720;

Scene scene_of(const std::string& name) {
  return read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes" / (name + ".json"));
}

/// Returns a deformable wall with elements of this size [m].
Scene swaying_wall(const Vec3& element_size) {
  Scene scene = scene_of("validation/swaying_wall");
  std::get<BoxShape>(scene.bodies[0].shape).element_size = element_size;
  return scene;
}

/// Scene to draw after some steps.
struct Subject {
  Subject(Scene shown, int steps, PictureQuality quality) : scene(std::move(shown)) {
    scene.view.quality = quality;
    World world(scene);
    EmbeddedDisplay display = embedded_display(world.frame(), scene);
    for (int i = 0; i < steps; ++i) world.step();
    follow_first_cracks(display, world.frame(), scene);
    scene.view.quantity = "material";
    drawn = draw_scene_from_frame(world.frame(), display, scene, scene.view, {});
    camera = scene_camera(scene, "", drawn, static_cast<float>(kWidth) / kHeight);
  }

  Scene scene;
  render::DrawScene drawn;
  render::Camera camera;
};

void draw(benchmark::State& state, const Scene& scene, int steps, PictureQuality quality) {
  const render::EglContext context(std::nullopt);
  const Subject subject(scene, steps, quality);
  render::Renderer renderer;
  const render::RenderOptions options = picture_options(kWidth, kHeight, std::nullopt, subject.scene.view);
  renderer.render(subject.drawn, subject.camera, options);  // the first one compiles shaders
  for (auto _ : state) {
    renderer.render(subject.drawn, subject.camera, options);
    benchmark::DoNotOptimize(renderer.id_at(0, 0));  // waits for the picture
  }
}

void add(const std::string& name, const Scene& scene, int steps) {
  const std::pair<const char*, PictureQuality> qualities[] = {
      {"/draft", PictureQuality::draft}, {"/standard", PictureQuality::standard}, {"/high", PictureQuality::high}};
  for (const auto& [suffix, quality] : qualities)
    benchmark::RegisterBenchmark((name + suffix).c_str(), draw, scene, steps, quality)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

}  // namespace
}  // namespace griffith::app

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (const auto& [name, steps] : {std::pair{"arch", 100},
                                    {"bear_shot", 50},
                                    {"block_stack", 60},
                                    {"brick_wall", 60},
                                    {"bridge", 110},
                                    {"cantilever", 10},
                                    {"column_collapse", 80},
                                    {"glass_pane", 40},
                                    {"materials", 40},
                                    {"plate_drop", 60},
                                    {"plate_with_hole", 20},
                                    {"remeshed_plate", 40},
                                    {"three_point_bending", 40},
                                    {"vase_shot", 40},
                                    {"wall_large", 60},
                                    {"wall_medium", 60},
                                    {"wall_small", 60},
                                    {"walls_16", 60},
                                    {"walls_32", 40},
                                    {"walls_4", 60},
                                    {"wood_beam", 40}})
    griffith::app::add(name, griffith::app::scene_of(name), steps);
  griffith::app::add("triangles_100000", griffith::app::swaying_wall({2.0 / 158, 2.0 / 158, 0.25}), 0);
  benchmark::RunSpecifiedBenchmarks();
}
