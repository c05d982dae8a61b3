#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/output/crack_event_file.h"
#include "app/output/energy_table.h"
#include "app/output/export_frame.h"
#include "app/output/export_pieces.h"
#include "app/output/file_formats.h"
#include "app/output/open_world.h"
#include "app/output/output.h"
#include "app/output/probe_table.h"
#include "app/output/statistics.h"
#include "app/shared/progress.h"
#include "app/study/run_record.h"
#include "sim/core/replace_file.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

/// Options of `simulate`.
struct SimulateOptions {
  std::filesystem::path scene;
  std::vector<std::string> set;  ///< "POINTER=VALUE"
  int frames = 0;
  std::filesystem::path stats;          ///< empty: prints a summary
  std::filesystem::path probes;         ///< CSV of the scene's probes; empty: none
  std::filesystem::path energy;         ///< CSV of the energy account; empty: none
  std::filesystem::path events;         ///< JSON of all crack events; empty: none
  std::filesystem::path export_file;    ///< .vtu or .msh of the last frame; empty: none
  std::filesystem::path export_pieces;  ///< folder for the last frame's bodies as .obj; empty: none
  std::filesystem::path outcomes;       ///< JSON of the outcomes; empty: none
  std::filesystem::path record;         ///< recording of the run; empty: none
  bool pack_outside = false;            ///< includes files from outside the scene's folder in the recording
  int threads = 1;                      ///< number of threads, for the report
};

/// Throws InputError for outputs that cannot be written, before the run.
void check_outputs(const SimulateOptions& options) {
  if (!options.export_file.empty()) check_export_path(options.export_file);
  if (!options.record.empty()) require_extension(options.record, ".tar.zst", "recording");
  for (const std::filesystem::path& path : {options.stats, options.probes, options.energy, options.events,
                                            options.export_file, options.outcomes, options.record})
    if (!path.empty()) check_replaceable(path);
  if (!options.export_pieces.empty()) check_folder(options.export_pieces);
}

/// Data that a run records at each step, as far as requested.
class Records {
 public:
  Records(const World& world, const SimulateOptions& options) {
    if (!options.probes.empty()) probes_.emplace(world, options.scene);
    if (!options.energy.empty()) energy_.emplace(world.frame());
    if (!options.record.empty()) recording_ = begin_recording(world, outside_files(options.pack_outside));
  }

  void add(const World& world) {
    if (probes_) probes_->add(world);
    if (energy_) energy_->add(world.frame());
    if (recording_) recording_->hashes.push_back(world.state_hashes());
  }

  void write(const SimulateOptions& options, Outputs& outputs) const {
    if (probes_) outputs.write([&] { replace_file(options.probes, probes_->csv()); });
    if (energy_) outputs.write([&] { replace_file(options.energy, energy_->csv()); });
    if (recording_) outputs.write([&] { write_recording(*recording_, options.record); });
  }

 private:
  std::optional<ProbeTable> probes_;
  std::optional<EnergyTable> energy_;
  std::optional<Recording> recording_;
};

void make_steps(World& world, int count, Records& records, RunStatistics& statistics) {
  Progress progress("Simulating", count);
  for (int step = 1; step <= count; ++step) {
    world.step();
    statistics.add(world.frame());
    records.add(world);
    progress.update(step);
  }
}

/// Writes the requested files about the last step.
void write_frame(const Frame& frame, const Shards& shards, const SimulateOptions& options, Outputs& outputs) {
  if (!options.events.empty()) outputs.write([&] { replace_file(options.events, crack_events_json(frame)); });
  if (!options.export_file.empty()) outputs.write([&] { export_frame(options.export_file, frame); });
  if (!options.export_pieces.empty()) outputs.write([&] { export_pieces(options.export_pieces, frame, shards); });
}

void simulate(const SimulateOptions& options) {
  check_outputs(options);
  const Scene scene = read_scene(options.scene, settings(options.set));
  World world = open_world(scene, options.scene);
  Records records(world, options);
  Shards shards;
  if (!options.export_pieces.empty()) shards = Shards(world.frame(), scene);
  RunStatistics statistics(world.frame(), scene.simulation.time_step, options.threads);
  make_steps(world, options.frames, records, statistics);
  const Frame frame = world.frame();
  shards.follow(frame, scene);
  Outputs outputs;
  records.write(options, outputs);
  write_frame(frame, shards, options, outputs);
  if (!options.outcomes.empty())
    outputs.write([&] { replace_file(options.outcomes, record_json({outcomes_of(frame, statistics.tally()), {}})); });
  if (options.stats.empty()) {
    print("%s", statistics.summary(frame, world.state_hash()).c_str());
  } else {
    outputs.write([&] { replace_file(options.stats, statistics.json(frame, world.state_hash())); });
  }
  outputs.finish();
}

}  // namespace

Command add_simulate(CLI::App& program) {
  CLI::App* command = program.add_subcommand("simulate", "Simulate a scene without graphics");
  const auto options = std::make_shared<SimulateOptions>();
  command->add_option("SCENE", options->scene, "Scene file")->required()->type_name("FILE");
  add_settings(*command, options->set);
  command->add_option("--frames", options->frames, "Number of time steps")
      ->required()
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command->add_option("--stats", options->stats, "Write statistics as JSON instead of a summary")->type_name("FILE");
  command->add_option("--probes", options->probes, "Write the scene's probes as CSV, one row per time step")
      ->type_name("FILE");
  command->add_option("--energy", options->energy, "Write the energy account as CSV, one row per time step")
      ->type_name("FILE");
  command
      ->add_option("--events", options->events,
                   "Write all crack events as JSON: place, plane, load, elements on both sides, bodies")
      ->type_name("FILE");
  command->add_option("--export", options->export_file, "Write the last time step as " + frame_formats_text())
      ->type_name("FILE");
  command
      ->add_option("--export-pieces", options->export_pieces,
                   "Write each body of the last time step as .obj into a folder, with its splinters if it has any")
      ->type_name("DIR");
  command->add_option("--outcomes", options->outcomes, "Write the outcomes as JSON: pieces, masses, cracks, energies")
      ->type_name("FILE");
  CLI::Option* record =
      command->add_option("--record", options->record,
                          "Write the run with all files of its scene and hashes of every step, for griffith replay");
  record->type_name("FILE");
  add_pack_outside(*command, options->pack_outside)->needs(record);
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith simulate scenes/wall_small.json --frames 600\n"
      "  griffith simulate scenes/wall_small.json --frames 60 --set projectiles/0/speed=20\n"
      "  griffith simulate scenes/brick_wall.json --frames 60 --export-pieces pieces\n"
      "  griffith simulate scenes/wall_small.json --frames 60 --export wall.vtu\n"
      "  griffith simulate scenes/wall_small.json --frames 120 --record wall.tar.zst\n"
      "  griffith simulate scenes/cantilever.json --frames 1 --probes cantilever.csv\n"
      "  griffith simulate scenes/wall_small.json --frames 600 --threads 1 --stats wall.stats.json");
  return {command, [command, options] {
            options->threads = thread_count(*command);
            simulate(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
