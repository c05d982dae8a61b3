#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/bake/run_baker.h"
#include "app/cli/commands.h"
#include "app/export/export_bake.h"
#include "app/output/open_world.h"
#include "app/output/output.h"
#include "app/render/frame_list.h"
#include "app/shared/progress.h"
#include "sim/core/replace_file.h"
#include "sim/recording/replay.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

/// Options of `export`.
struct ExportOptions {
  std::filesystem::path input;   ///< scene or recording
  std::vector<std::string> set;  ///< "POINTER=VALUE"
  std::string frames;            ///< "A:B" or "A:B:STEP"
  std::vector<std::filesystem::path> outputs;
  bool deformed = false;  ///< includes elastic deformation
};

std::vector<int> frames_of(const ExportOptions& options) {
  if (options.frames.find(',') != std::string::npos)
    throw InputError("--frames", "is a list", "give one range with an even stride, such as 0:60 or 0:240:4");
  return frames_from_text(options.frames, "--frames");
}

void check_bake_outputs(const ExportOptions& options) {
  for (const std::filesystem::path& output : options.outputs) {
    check_bake_path(output);
    check_replaceable(output);
  }
}

/// Follows a world from its start to the last frame. `advance`: makes the next step.
template <class Advance>
Bake baked_run(const World& world, const Scene& scene, const ExportOptions& options, const Advance& advance) {
  const std::vector<int> frames = frames_of(options);
  RunBaker baker(world.frame(), scene);
  {
    Progress progress("Simulating", std::max(frames.back(), 1));
    for (const int frame : frames) {
      while (world.frame().step < frame) {
        advance();
        progress.update(static_cast<int>(world.frame().step));
      }
      baker.follow(world.frame());
    }
  }
  return baker.finish(world.frame(), options.deformed);
}

Bake baked_scene(const ExportOptions& options) {
  const Scene scene = read_scene(options.input, settings(options.set));
  World world = open_world(scene, options.input);
  return baked_run(world, scene, options, [&] { world.step(); });
}

Bake baked_recording(const ExportOptions& options) {
  if (!options.set.empty())
    throw InputError("--set", "cannot be used with a recording", "leave it out: a recording has its own scene");
  const Recording recording = read_recording(options.input);
  if (frames_of(options).back() > recording.steps())
    throw InputError("--frames", "goes beyond the recording's " + std::to_string(recording.steps()) + " steps",
                     "end there or earlier");
  Replay replay(recording);
  return baked_run(replay.world(), replay.scene(), options, [&] { replay.advance(); });
}

std::string counted(std::size_t count, const std::string& object) {
  return std::to_string(count) + ' ' + object + (count == 1 ? "" : "s");
}

void print_written(const std::filesystem::path& path, const Bake& bake, std::size_t bytes) {
  const auto is_projectile = [](const BakedObject& object) { return object.scene_body < 0; };
  const auto projectiles = static_cast<std::size_t>(std::ranges::count_if(bake.objects, is_projectile));
  print("%s: %s, %s, %s, %.1f MB\n", path.c_str(), counted(bake.objects.size() - projectiles, "piece").c_str(),
        counted(projectiles, "projectile").c_str(), counted(bake.times.size(), "frame").c_str(),
        static_cast<double>(bytes) / 1e6);
}

void export_run(const ExportOptions& options) {
  check_bake_outputs(options);
  const Bake bake = is_recording(options.input) ? baked_recording(options) : baked_scene(options);
  Outputs outputs;
  for (const std::filesystem::path& output : options.outputs)
    outputs.write([&] { print_written(output, bake, export_bake(output, bake)); });
  outputs.finish();
  check_stdout();
}

}  // namespace

Command add_export(CLI::App& program) {
  CLI::App* command = program.add_subcommand("export", "Export a run to other programs: pieces, motion and bonds");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("SCENE", options->input, "Scene file to run, or a recording")->required()->type_name("FILE");
  add_settings(*command, options->set);
  command->add_option("--frames", options->frames, "Time steps A:B to write, or A:B:STRIDE")
      ->required()
      ->type_name("LIST");
  command->add_option("-o,--output", options->outputs, "Output file: " + bake_formats_text() + "; may be repeated")
      ->required()
      ->expected(1)
      ->take_all()
      ->type_name("FILE");
  command->add_flag("--deformed", options->deformed,
                    "Include elastic deformation: morph targets in .glb, points in .usda, one set per frame");
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith export scenes/glass_pane.json --frames 0:60 -o pane.glb\n"
      "  griffith export scenes/glass_pane.json --frames 0:60 -o pane.usda -o bonds.json -o bonds.csv\n"
      "  griffith export scenes/glass_pane.json --frames 0:60 -o pane.html\n"
      "  griffith export scenes/cantilever.json --frames 0:30 --deformed -o cantilever.glb\n"
      "  griffith export wall.tar.zst --frames 0:120:2 -o wall.glb");
  return {command, [options] {
            export_run(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
