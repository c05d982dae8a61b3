#include <gtest/gtest.h>

#include <atomic>
#include <ctime>

#include "sim/world/world.h"

namespace griffith {
namespace {

/// A body whose building takes long in each of its stages.
Scene large_beam() {
  BodyDescription beam;
  beam.shape = BoxShape{Vec3(4, 0.5, 0.5), Vec3::Constant(0.05), BoxPattern::five_tet};
  beam.supports = {{BoxRegion{Vec3(-2, -0.25, -0.25), Vec3(-2, 0.25, 0.25)}}};
  beam.splinters = VoronoiSplinters{};
  Scene scene;
  scene.bodies = {beam};
  return scene;
}

/// Counted in processor time, which does not depend on what else the machine does.
TEST(CancelledBuilding, IsAskedForAgainAndAgain) {
  const std::clock_t start = std::clock();
  std::atomic<std::clock_t> last = start, longest = 0;
  Monitor monitor;
  monitor.cancelled = [&] {
    const std::clock_t now = std::clock(), gap = now - last.exchange(now);
    if (gap > longest.load()) longest = gap;
    return false;
  };
  const World world(large_beam(), monitor);
  EXPECT_LT(longest.load(), (std::clock() - start) / 3);
}

TEST(CancelledBuilding, EndsWhereItIs) {
  for (const int questions : {1, 10, 100}) {
    std::atomic<int> asked = 0;
    Monitor monitor;
    monitor.cancelled = [&] { return ++asked > questions; };
    EXPECT_THROW(World(large_beam(), monitor), Cancelled) << questions;
  }
}

}  // namespace
}  // namespace griffith
