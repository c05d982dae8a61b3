#include <imgui.h>

#include <cstdio>
#include <functional>

#include "app/command_options.h"
#include "app/editor.h"
#include "app/interface.h"
#include "app/progress.h"
#include "app/scene_camera.h"
#include "app/scene_legend.h"
#include "app/scene_world.h"
#include "renderer/egl_context.h"
#include "renderer/target.h"
#include "sim/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/view_quantity.h"

namespace griffith::app {
namespace {

constexpr int kFramesToLayOut = 3;  // the panels know their sizes only after being drawn

void use_view(ViewSettings& view, const std::string& quantity) {
  if (quantity.empty()) return;
  std::string names;
  for (const ViewQuantity& known : view_quantities()) {
    if (known.key == quantity) {
      if (view.quantity != quantity) view.range.reset();
      view.quantity = quantity;
      return;
    }
    names += (names.empty() ? "" : ", ") + std::string(known.key);
  }
  throw InputError("--view", "there is no quantity \"" + quantity + "\"", "it is one of " + names);
}

std::filesystem::path numbered(const std::filesystem::path& path, int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "_%04d", frame);
  std::filesystem::path result = path.parent_path() / path.stem();
  result += number;
  result += path.extension();
  return result;
}

/// Steps to the last frame and saves the pictures that were asked for.
void save_pictures(const RenderOptions& options, const std::function<void()>& step,
                   const std::function<render::Image()>& picture) {
  Progress progress("Rendering", std::max(options.frame, 1));
  for (int frame = 0;; ++frame) {
    if (options.every > 0 && frame % options.every == 0) save_png(numbered(options.output, frame), picture());
    if (frame == options.frame) break;
    step();
    progress.update(frame + 1);
  }
  if (options.every == 0) save_png(options.output, picture());
}

/// The picture in `texture` with the legend over it.
render::Image with_legend(Interface& interface, const render::Target& target, unsigned texture,
                          const ui::Legend& legend) {
  interface.begin_frame(target.width(), target.height());
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {0, 0}, size, {0, 1}, {1, 0});
  ui::draw_legend(list, legend, interface.fonts(), {0, 0}, size, 1);
  target.bind();
  interface.end_frame();
  return target.image();
}

void render_plainly(const RenderOptions& options, const Scene& scene) {
  World world = make_world(scene, options.scene);
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  render::Renderer renderer;
  Interface interface(1);
  const render::Target target(options.width, options.height);
  const auto draw_scene = [&] { return draw_scene_from_frame(world.frame(), display, scene, scene.view, {}); };
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const render::Camera camera = scene_camera(scene, options.camera, draw_scene(), aspect);
  const auto picture = [&] {
    const render::DrawScene drawn = draw_scene();
    renderer.render(
        drawn, camera,
        {.width = options.width, .height = options.height, .samples = options.samples, .edges = scene.view.edges});
    const std::optional<ui::Legend> legend = scene_legend(drawn, scene.view.range.has_value());
    if (!options.legend || !legend) return renderer.image();
    return with_legend(interface, target, renderer.color_texture(), *legend);
  };
  save_pictures(
      options, [&world] { world.step(); }, picture);
}

void render_editor(const RenderOptions& options, const Scene& scene) {
  Editor editor(scene, options.scene);
  editor.use_camera(options.camera);
  editor.state().show_times = false;
  Interface interface(1);
  const render::Target target(options.width, options.height);
  const auto picture = [&] {
    for (int i = 0; i < kFramesToLayOut; ++i) {
      editor.draw_picture(options.samples);
      interface.begin_frame(options.width, options.height);
      editor.draw_panels(interface.fonts());
      target.bind();
      target.clear({});
      interface.end_frame();
    }
    return target.image();
  };
  save_pictures(
      options, [&editor] { editor.step(); }, picture);
}

}  // namespace

void render_command(const RenderOptions& options) {
  if (options.output.extension() != ".png")
    throw InputError(options.output.string(), "is no name of a PNG file", "end it in .png");
  Scene scene = read_scene(options.scene);
  use_view(scene.view, options.view);
  const render::EglContext context(options.egl_device);
  std::fprintf(stderr, "Graphics: %s (%s)\n", context.renderer().c_str(), context.origin().c_str());
  if (options.interface) {
    render_editor(options, scene);
  } else {
    render_plainly(options, scene);
  }
}

}  // namespace griffith::app
