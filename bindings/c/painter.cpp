#include "app/render/picture_maker.h"
#include "bindings/c/guarded.h"
#include "bindings/c/handles.h"
#include "renderer/egl_context.h"
#include "renderer/error.h"

using namespace griffith;
using namespace griffith::c;

namespace {

app::RenderJob job_of(int width, int height, const char* camera, const char* view) {
  app::RenderJob job;
  job.width = width;
  job.height = height;
  job.cameras = {camera ? camera : ""};
  job.views = {view ? view : ""};
  return job;
}

}  // namespace

/// A context of its own, made current for each call, with its renderer.
struct griffith_painter {
  griffith_painter(const World& world, const app::RenderJob& render_job)
      : job(render_job), pictures(job, world.scene(), world) {}

  render::EglContext context;
  app::RenderJob job;
  app::PictureMaker pictures;
  render::Image image;
};

griffith_status griffith_painter_create(const griffith_world* world, std::int32_t width, std::int32_t height,
                                        const char* camera, const char* view, griffith_painter** painter,
                                        griffith_error* error) {
  return guarded(error, [&] {
    constexpr std::int32_t kMin = 16, kMax = 8192;
    const griffith_world& drawn = object_of(world, "world");
    griffith_painter*& made = object_of(painter, "painter");
    require(width >= kMin && width <= kMax, "width", "is out of range", "16 to 8192 pixels");
    require(height >= kMin && height <= kMax, "height", "is out of range", "16 to 8192 pixels");
    require(drawn.world.frame().crack_events.empty(), "world", "has cracked already",
            "make the painter before the first step");
    try {
      made = new griffith_painter(drawn.world, job_of(width, height, camera, view));
    } catch (const render::RenderError& missing) {
      throw InputError("graphics", missing.what(), "install an OpenGL driver, such as Debian's libgl1-mesa-dri");
    }
  });
}

griffith_status griffith_painter_paint(griffith_painter* painter, const griffith_world* world, griffith_array* pixels,
                                       griffith_error* error) {
  return guarded(error, [&] {
    griffith_painter& drawing = object_of(painter, "painter");
    const griffith_world& drawn = object_of(world, "world");
    griffith_array& rows = object_of(pixels, "pixels");
    drawing.context.make_current();
    drawing.pictures.follow(drawn.world);
    drawing.image = drawing.pictures.paint(drawn.world, drawing.job.cameras.front(), drawing.job.views.front()).image;
    rows = {drawing.image.rgba.data(), drawing.job.height, 4LL * drawing.job.width, GRIFFITH_UINT8, 2,
            {drawing.job.width, 4}};
  });
}

void griffith_painter_destroy(griffith_painter* painter) {
  if (painter) painter->context.make_current();  // releases its graphics objects
  delete painter;
}
