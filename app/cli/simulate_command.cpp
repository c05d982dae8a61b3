#include <cstdio>
#include <optional>

#include "app/output/crack_event_file.h"
#include "app/output/energy_table.h"
#include "app/output/export_frame.h"
#include "app/output/export_pieces.h"
#include "app/output/output.h"
#include "app/output/probe_table.h"
#include "app/output/statistics.h"
#include "app/shared/command_options.h"
#include "app/shared/progress.h"
#include "app/shared/scene_world.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

/// What can be told before the run of where its results go.
void check_outputs(const SimulateOptions& options) {
  if (!options.export_file.empty()) check_export_path(options.export_file);
  for (const std::filesystem::path& path :
       {options.stats, options.probes, options.energy, options.events, options.export_file})
    if (!path.empty()) check_replaceable(path);
  if (!options.export_pieces.empty()) check_folder(options.export_pieces);
}

}  // namespace

void simulate_command(const SimulateOptions& options) {
  check_outputs(options);
  const Scene scene = read_scene(options.scene);
  World world = make_world(scene, options.scene);
  std::optional<ProbeTable> probes;
  if (!options.probes.empty()) probes.emplace(world, options.scene);
  std::optional<EnergyTable> energy;
  if (!options.energy.empty()) energy.emplace(world.frame());
  std::vector<Skin> skins;
  if (!options.export_pieces.empty()) skins = make_skins(world.frame(), scene);
  RunStatistics statistics(world.frame(), scene.simulation.time_step, options.threads);
  {
    Progress progress("Simulating", options.frames);
    for (int step = 1; step <= options.frames; ++step) {
      world.step();
      statistics.add(world.frame());
      if (probes) probes->add(world);
      if (energy) energy->add(world.frame());
      progress.update(step);
    }
  }
  const Frame frame = world.frame();
  Outputs outputs;
  if (probes) outputs.write([&] { replace_file(options.probes, probes->csv()); });
  if (energy) outputs.write([&] { replace_file(options.energy, energy->csv()); });
  if (!options.events.empty()) outputs.write([&] { replace_file(options.events, crack_events_json(frame)); });
  if (!options.export_file.empty()) outputs.write([&] { export_frame(options.export_file, frame); });
  if (!options.export_pieces.empty()) outputs.write([&] { export_pieces(options.export_pieces, frame, skins); });
  if (options.stats.empty()) {
    std::printf("%s", statistics.summary(frame, world.state_hash()).c_str());
  } else {
    outputs.write([&] { replace_file(options.stats, statistics.json(frame, world.state_hash())); });
  }
  outputs.finish();
}

}  // namespace griffith::app
