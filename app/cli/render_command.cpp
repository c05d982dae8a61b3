#include <imgui.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

#include "app/cli/commands.h"
#include "app/editor/editor.h"
#include "app/editor/imgui_context_owner.h"
#include "app/output/output.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "app/picture/steady_range.h"
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

/// Pictures without a window.
struct RenderOptions {
  std::filesystem::path scene, output;
  int frame = 0;                   ///< steps before the (last) picture
  int every = 0;                   ///< a picture each so many steps from 0 on, numbered; 0: one picture
  int width = 1280, height = 720;  ///< [pixels]
  int samples = 4;                 ///< per pixel
  std::string view, camera;        ///< empty: the scene's
  std::optional<int> node;         ///< whose forces and plane are shown; the most loaded one if absent
  bool interface = false;          ///< draw the editor's panels too
  bool legend = true;
  std::optional<int> egl_device;
};

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

void render(const RenderOptions& options) {
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

constexpr int kMaxPixels = 16384;

/// "1280x720" into two numbers; what is wrong with it.
std::string read_size(const std::string& text, RenderOptions& options) {
  char rest = 0;
  const bool good = std::sscanf(text.c_str(), "%dx%d%c", &options.width, &options.height, &rest) == 2;
  const auto possible = [](int pixels) { return pixels >= 16 && pixels <= kMaxPixels; };
  if (good && possible(options.width) && possible(options.height)) return {};
  return "--size: \"" + text + "\" is not a size: write WIDTHxHEIGHT, such as 1280x720, each from 16 to 16384";
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw a scene into PNG files, without a window");
  const auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "Scene file")->required()->type_name("FILE");
  command->add_option("--frame", options->frame, "Time steps before the picture")
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command->add_option("-o,--output", options->output, "PNG file to write")->required()->type_name("FILE");
  command->add_option("--every", options->every, "A numbered picture every K steps, from 0 to N")
      ->check(CLI::Range(1, kMaxFrames))
      ->type_name("K");
  command
      ->add_option_function<std::string>(
          "--size",
          [options](const std::string& text) {
            const std::string problem = read_size(text, *options);
            if (!problem.empty()) throw CLI::ValidationError(problem);
          },
          "Size of the picture, 1280x720 if not given")
      ->type_name("WxH");
  command->add_option("--samples", options->samples, "Samples per pixel, 4 if not given; 1 has no smoothed edges")
      ->check(CLI::Range(1, 16))
      ->type_name("S");
  command
      ->add_option(
          "--view", options->view,
          "What to show: a quantity to colour by, a layer, wireframe, shrunken, exploded, slice or unlit; several "
          "joined by +, such as utilization+fracture_planes+slice. The scene's view if not given")
      ->type_name("NAME");
  command
      ->add_option("--node", options->node,
                   "Node that is explained, in text and by the views candidate_plane and element_forces; the most "
                   "loaded one if not given")
      ->check(CLI::Range(0, 1 << 30))
      ->type_name("N");
  command->add_option("--camera", options->camera, "Camera of the scene, the first if not given")->type_name("NAME");
  command->add_flag("--ui", options->interface, "Draw the editor's panels into the picture");
  command->add_flag("--legend,!--no-legend", options->legend, "Draw the legend of the colours; on if not given");
  command->add_option("--egl-device", options->egl_device, "Graphics device to use, as EGL counts them")
      ->check(CLI::Range(0, 64))
      ->type_name("N");
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith render scenes/wall_small.json --frame 60 -o wall.png\n"
      "  griffith render scenes/wall_small.json --frame 240 --every 4 -o wall.png    wall_0000.png, wall_0004.png, "
      "...\n"
      "  griffith render scenes/wall_small.json --frame 30 --view utilization --size 1920x1080 -o utilization.png");
  return {command, [options] {
            render(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
