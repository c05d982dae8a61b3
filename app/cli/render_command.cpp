#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "app/editor/editor.h"
#include "app/editor/imgui_context_owner.h"
#include "app/output/output.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "app/picture/steady_range.h"
#include "app/shared/command_options.h"
#include "app/shared/explanation.h"
#include "app/shared/progress.h"
#include "app/shared/scene_world.h"
#include "renderer/egl_context.h"
#include "renderer/target.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

/// The largest scale that letters are made for; beyond it they are stretched.
constexpr float kLargestFont = 6;
constexpr int kFramesToLayOut = 3;  // the panels know their sizes only after being drawn

/// Direction from what is looked at to the eye, before there is a picture.
Vec3 towards_eye(const Scene& scene, const std::string& camera) {
  for (const Camera& known : scene.cameras)
    if (camera.empty() || known.name == camera) return known.position - known.target;
  return Vec3::UnitZ();
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
    if (options.every > 0 && frame % options.every == 0) save_picture(numbered(options.output, frame), picture());
    if (frame == options.frame) break;
    step();
    progress.update(frame + 1);
  }
  if (options.every == 0) save_picture(options.output, picture());
}

/// The node that was asked for, while there is one of that number. Throws InputError where the last step has none.
ui::Selection selected(const RenderOptions& options, const Frame& frame) {
  if (!options.node) return {};
  const auto nodes = static_cast<int>(frame.nodes.positions.size());
  if (*options.node >= nodes && frame.step >= options.frame)
    throw InputError("--node", "there is no node " + std::to_string(*options.node),
                     "take one below " + std::to_string(nodes) + "; cracks make more");
  if (*options.node >= nodes) return {};
  const NodeId node(*options.node);
  return ui::select(frame, frame.nodes.stars[node].front(), node);
}

void explain(const RenderOptions& options, const Frame& frame, const Scene& scene) {
  if (options.node) std::fputs(explanation(frame, NodeId(*options.node), scene.simulation.fracture).c_str(), stdout);
}

/// What is written over a picture.
struct Writing {
  std::optional<ui::Legend> legend;
  std::vector<ui::PictureLabel> labels;
};

/// The picture in `texture` with the writing over it. `scale`: of the writing.
render::Image written_over(ImGuiContextOwner& imgui, const render::Target& target, unsigned texture,
                           const Writing& writing, float scale) {
  imgui.begin_frame(target.width(), target.height());
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {0, 0}, size, {0, 1}, {1, 0});
  ui::draw_labels(list, writing.labels, imgui.fonts(), {0, 0}, size, scale);
  if (writing.legend) ui::draw_legend(list, *writing.legend, imgui.fonts(), {{0, 0}, size}, scale);
  target.bind();
  imgui.end_frame();
  return target.image();
}

void render_plainly(const RenderOptions& options, Scene scene) {
  World world = make_world(scene, options.scene);
  use_named_view(scene.view, options.view, world.frame(), towards_eye(scene, options.camera));
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  render::Renderer renderer;
  const float scale = writing_scale(options.width, options.height);
  ImGuiContextOwner imgui(std::min(scale, kLargestFont));
  const render::Target target(options.width, options.height);
  SteadyRange range;
  range.follow(world.frame(), scene.view.quantity);
  const auto draw_scene = [&] {
    const Frame frame = world.frame();
    return draw_scene_from_frame(frame, display, scene, scene.view, selected(options, frame), range.range());
  };
  const auto step = [&] {
    world.step();
    range.follow(world.frame(), scene.view.quantity);
  };
  const ImVec2 size(static_cast<float>(options.width), static_cast<float>(options.height));
  const float aspect = size.x / size.y;
  const render::DrawScene first = draw_scene();
  const render::Camera camera = scene_camera(scene, options.camera, first, aspect);
  // Where the first picture leaves room it stays, so that it does not hop about in a sequence.
  ui::LegendCorner corner = {};
  if (const auto legend = scene_legend(first, false))
    corner = legend_corner(first, camera, *legend, imgui.fonts(), size, scale);
  const auto picture = [&] {
    const render::DrawScene drawn = draw_scene();
    renderer.render(drawn, camera, picture_options(options.width, options.height, options.samples, scene.view));
    Writing writing{scene_legend(drawn, scene.view.range.has_value()), scene_labels(drawn, camera, aspect)};
    if (writing.legend) writing.legend->corner = corner;
    if (!options.legend || (!writing.legend && writing.labels.empty())) return renderer.image();
    return written_over(imgui, target, renderer.color_texture(), writing, scale);
  };
  save_pictures(options, step, picture);
  explain(options, world.frame(), scene);
}

void render_editor(const RenderOptions& options, const Scene& scene) {
  Editor editor(scene, options.scene);
  editor.use_camera(options.camera);
  editor.use_view(options.view);
  editor.state().show_times = false;
  ImGuiContextOwner imgui(1);
  const render::Target target(options.width, options.height);
  const auto picture = [&] {
    if (options.node) editor.state().selection = selected(options, editor.frame());
    for (int i = 0; i < kFramesToLayOut; ++i) {
      editor.draw_picture(options.samples);
      imgui.begin_frame(options.width, options.height);
      editor.draw_panels(imgui.fonts());
      target.bind();
      target.clear({});
      imgui.end_frame();
    }
    return target.image();
  };
  save_pictures(
      options, [&editor] { editor.step(); }, picture);
  explain(options, editor.frame(), scene);
}

}  // namespace

void render_command(const RenderOptions& options) {
  if (options.output.extension() != ".png")
    throw InputError(options.output.string(), "is no name of a PNG file", "end it in .png");
  check_replaceable(options.every > 0 ? numbered(options.output, 0) : options.output);
  const Scene scene = read_scene(options.scene);
  const render::EglContext context(options.egl_device);
  std::fprintf(stderr, "Graphics: %s (%s)\n", context.renderer().c_str(), context.origin().c_str());
  if (options.interface) {
    render_editor(options, scene);
  } else {
    render_plainly(options, scene);
  }
}

}  // namespace griffith::app
