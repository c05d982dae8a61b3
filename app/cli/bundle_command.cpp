#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/output/bug_report.h"
#include "app/output/file_formats.h"
#include "app/output/open_world.h"
#include "app/output/output.h"
#include "app/output/replay_report.h"
#include "app/output/statistics.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/shared/progress.h"
#include "renderer/egl_context.h"
#include "renderer/renderer.h"
#include "sim/core/replace_file.h"
#include "sim/recording/recording.h"
#include "sim/recording/replay.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

/// Options of `bundle`.
struct BundleOptions {
  std::filesystem::path input, output;
  std::optional<int> frames;  ///< frames of a scene; 60 if not given
  bool pack_outside = false;  ///< includes files from outside the scene's folder
  int threads = 1;
};

/// Draws a world that began as `first` like `griffith render`, or reports in `parts` why it cannot. Returns the name of
/// the renderer.
std::string add_picture(const World& first, const World& world, const Scene& scene, ReportParts& parts) try {
  constexpr int kWidth = 1280, kHeight = 720;
  const render::EglContext context(std::nullopt);
  CopyOnWrite display(embedded_display(first.frame(), scene));
  SteadyRange range;
  const render::DrawScene drawn = draw_next_step(world.frame(), display, range, scene, scene.view);
  render::Renderer renderer;
  const render::Camera camera = scene_camera(scene, "", drawn, static_cast<float>(kWidth) / kHeight);
  renderer.render(drawn, camera, picture_options(kWidth, kHeight, std::nullopt, scene.view));
  parts.picture = renderer.image();
  return context.renderer();
} catch (const std::exception& error) {
  parts.log += std::string("no picture: ") + error.what() + "\n";
  return "none";
}

/// Runs the scene until its end or an error.
Recording recorded_run(const BundleOptions& options, ReportParts& parts) {
  const Scene scene = read_scene(options.input);
  const World first = open_world(scene, options.input);
  World world = first;
  Recording recording = begin_recording(world, outside_files(options.pack_outside));
  for (const InputError& finding : world.findings()) parts.log += "warning: " + printable(finding.what()) + "\n";
  RunStatistics statistics(world.frame(), scene.simulation.time_step, options.threads);
  const int frames = options.frames.value_or(60);
  try {
    Progress progress("Simulating", std::max(frames, 1));
    for (int step = 1; step <= frames; ++step) {
      world.step();
      statistics.add(world.frame());
      recording.hashes.push_back(world.state_hashes());
      progress.update(step);
    }
  } catch (const std::exception& error) {
    parts.log += "step " + std::to_string(recording.steps() + 1) + " failed: " + error.what() + "\n";
  }
  parts.log += statistics.summary(world.frame(), world.state_hash());
  recording.versions.emplace_back("graphics", add_picture(first, world, scene, parts));
  return recording;
}

/// Replays a recording for its picture, and reports whether its results are the same here.
Recording replayed(const BundleOptions& options, ReportParts& parts) {
  Recording recording = read_recording(options.input);
  Replay replay(recording);
  const World first = replay.world();
  Progress progress("Replaying", static_cast<int>(std::max<std::int64_t>(recording.steps(), 1)));
  while (!replay.at_end()) {
    replay.advance();
    progress.update(static_cast<int>(replay.world().frame().step));
  }
  parts.log += "replayed for this report: " + replay_report(recording, replay);
  parts.log += "picture drawn by: " + add_picture(first, replay.world(), replay.scene(), parts) + "\n";
  return recording;
}

void bundle(const BundleOptions& options) {
  const bool recorded = is_recording(options.input);
  if (recorded && options.frames)
    throw InputError("--frames", "cannot be used with a recording", "leave it out: a recording has its own steps");
  require_extension(options.output, ".tar.zst", "bug report");
  check_replaceable(options.output);
  ReportParts parts;
  parts.log = "griffith bundle " + options.input.filename().string() + "\n";
  Recording recording = recorded ? replayed(options, parts) : recorded_run(options, parts);
  add_report(recording, parts);
  write_recording(recording, options.output);
  print("%s: %lld steps%s\n%s", options.output.c_str(), static_cast<long long>(recording.steps()),
        parts.picture ? ", with a picture of the last" : ", without a picture", parts.log.c_str());
}

}  // namespace

Command add_bundle(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("bundle", "Pack a run with everything needed to repeat it elsewhere: a bug report");
  const auto options = std::make_shared<BundleOptions>();
  command->add_option("SCENE", options->input, "Scene file to run, or a recording")->required()->type_name("FILE");
  command->add_option("--frames", options->frames, "Time steps of a scene; default: 60. A recording has its own")
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command->add_option("-o,--output", options->output, "Bug report to write")->required()->type_name("FILE");
  add_pack_outside(*command, options->pack_outside);
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith bundle scenes/wall_small.json --frames 120 -o report.tar.zst\n"
      "  griffith bundle wall.tar.zst -o report.tar.zst\n"
      "  griffith replay report.tar.zst\n\n"
      "It holds the scene with its files, inputs, hashes of every step, versions, a log and a picture of the last "
      "step.");
  return {command, [command, options] {
            options->threads = thread_count(*command);
            bundle(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
