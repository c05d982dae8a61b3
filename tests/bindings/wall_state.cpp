// The last line of the examples that use libgriffith, by the library itself.
#include <algorithm>
#include <cstdio>

#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

int main(int, char** arguments) {
  griffith::World world(griffith::read_scene(arguments[1]));
  for (int step = 0; step < 60; ++step) world.step();
  double highest = 0;
  for (const griffith::NodeSeparation& node : world.frame().nodes.separations)
    highest = std::max(highest, node.utilization);
  std::printf("%zu pieces, highest utilization %.3f, state %016llx\n", world.frame().bodies.size(), highest,
              static_cast<unsigned long long>(world.state_hash()));
}
