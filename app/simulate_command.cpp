#include <cstdio>

#include "app/command_options.h"
#include "app/progress.h"
#include "app/statistics.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {

void simulate_command(const SimulateOptions& options) {
  const Scene scene = read_scene(options.scene);
  World world(scene);
  RunStatistics statistics(world.frame(), scene.simulation.time_step, options.threads);
  {
    Progress progress("Simulating", options.frames);
    for (int step = 1; step <= options.frames; ++step) {
      world.step();
      statistics.add(world.frame());
      progress.update(step);
    }
  }
  if (options.stats.empty()) {
    std::printf("%s", statistics.summary(world.frame(), world.state_hash()).c_str());
  } else {
    write_text_file(options.stats, statistics.json(world.frame(), world.state_hash()));
  }
}

}  // namespace griffith::app
