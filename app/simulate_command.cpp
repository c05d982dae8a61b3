#include <cstdio>
#include <optional>

#include "app/command_options.h"
#include "app/crack_event_file.h"
#include "app/export_frame.h"
#include "app/export_pieces.h"
#include "app/probe_table.h"
#include "app/progress.h"
#include "app/scene_world.h"
#include "app/statistics.h"
#include "sim/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {

void simulate_command(const SimulateOptions& options) {
  if (!options.export_file.empty()) check_export_path(options.export_file);
  const Scene scene = read_scene(options.scene);
  World world = make_world(scene, options.scene);
  std::optional<ProbeTable> probes;
  if (!options.probes.empty()) probes.emplace(world, options.scene);
  std::vector<Skin> skins;
  if (!options.export_pieces.empty()) skins = make_skins(world.frame(), scene);
  RunStatistics statistics(world.frame(), scene.simulation.time_step, options.threads);
  {
    Progress progress("Simulating", options.frames);
    for (int step = 1; step <= options.frames; ++step) {
      world.step();
      statistics.add(world.frame());
      if (probes) probes->add(world);
      progress.update(step);
    }
  }
  if (probes) replace_file(options.probes, probes->csv());
  if (!options.events.empty()) replace_file(options.events, crack_events_json(world.frame()));
  if (!options.export_file.empty()) export_frame(options.export_file, world.frame());
  if (!options.export_pieces.empty()) export_pieces(options.export_pieces, world.frame(), skins);
  if (options.stats.empty()) {
    std::printf("%s", statistics.summary(world.frame(), world.state_hash()).c_str());
  } else {
    replace_file(options.stats, statistics.json(world.frame(), world.state_hash()));
  }
}

}  // namespace griffith::app
