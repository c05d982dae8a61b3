#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/render/thumbnail.h"
#include "renderer/egl_context.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

struct ThumbnailOptions {
  std::filesystem::path scene, output;
};

void write_thumbnail(const ThumbnailOptions& options) {
  check_replaceable(options.output);
  const Scene scene = read_scene(options.scene);
  const render::EglContext context;
  replace_file(options.output, render::encode_png(thumbnail(scene, options.scene)));
}

}  // namespace

Command add_thumbnail(CLI::App& program) {
  CLI::App* command = program.add_subcommand("thumbnail", "Draw a small picture of what happens in a scene");
  const auto options = std::make_shared<ThumbnailOptions>();
  command->add_option("SCENE", options->scene, "Scene file")->required()->type_name("FILE");
  command->add_option("-o,--output", options->output, "PNG file to write")->required()->type_name("FILE");
  add_threads(*command);
  command->footer(
      "Example:\n  griffith thumbnail scenes/glass_pane.json -o pane.png\n\n"
      "Shows the scene some time steps after its first crack, in 480x270 pixels.");
  return {command, [options] {
            write_thumbnail(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
