#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/file_formats.h"
#include "app/output/output.h"
#include "app/render/thumbnail.h"
#include "app/shared/scene_files.h"
#include "renderer/egl_context.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

struct ThumbnailOptions {
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path output;
  bool ship = false;
};

void write_thumbnail(const std::filesystem::path& scene, const std::filesystem::path& output) {
  require_extension(output, ".png", "PNG file");
  check_replaceable(output);
  const Scene read = read_scene(scene);
  const render::EglContext context;
  replace_file(output, render::encode_png(thumbnail(read, scene)));
}

/// Draws the thumbnail shipped with a scene if it is missing or older than the scene.
void ship_thumbnail_of(const std::filesystem::path& scene) {
  if (shipped_thumbnail(scene)) return;
  ship_thumbnail(scene, thumbnail(read_scene(scene), scene));
  print("%s\n", shipped_thumbnail_file(scene).c_str());
}

/// Draws missing thumbnails of scenes and of all scenes in folders, and reports stale files.
void ship_thumbnails(const std::vector<std::filesystem::path>& paths) {
  const render::EglContext context;
  for (const std::filesystem::path& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      ship_thumbnail_of(path);
      continue;
    }
    for (const std::filesystem::path& scene : scenes_in(path)) ship_thumbnail_of(scene);
    for (const std::filesystem::path& stale : stale_thumbnails(path))
      print("%s belongs to no current scene\n", stale.c_str());
  }
}

}  // namespace

Command add_thumbnail(CLI::App& program) {
  CLI::App* command = program.add_subcommand("thumbnail", "Draw a thumbnail of a scene");
  const auto options = std::make_shared<ThumbnailOptions>();
  command->add_option("SCENE", options->scenes, "Scene file, or with --ship a folder of them")
      ->required()
      ->type_name("FILE");
  CLI::Option* output =
      command->add_option("-o,--output", options->output, "PNG file to write, for one scene")->type_name("FILE");
  command
      ->add_flag("--ship", options->ship,
                 "Write the shipped thumbnails: into the folder thumbnails next to each scene, if missing or outdated")
      ->excludes(output);
  add_threads(*command);
  command->footer(
      "Example:\n  griffith thumbnail scenes/glass_pane.json -o pane.png\n\n"
      "Shows the scene some time steps after its first crack, in 480x270 pixels. The scene browser shows those written "
      "by\n"
      "  griffith thumbnail --ship scenes scenes/validation\nat once, and draws the others.");
  return {command, [options] {
            if (options->ship) {
              ship_thumbnails(options->scenes);
            } else if (options->scenes.size() == 1 && !options->output.empty()) {
              write_thumbnail(options->scenes.front(), options->output);
            } else {
              throw InputError("the command thumbnail",
                               options->output.empty() ? "has no output" : "writes one file, for one scene",
                               "give one scene and -o FILE, or --ship with any number of scenes");
            }
            return kDone;
          }};
}

}  // namespace griffith::app
