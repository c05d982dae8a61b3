#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "sim/world/world.h"

namespace griffith {
namespace {

using Clock = std::chrono::steady_clock;

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

TEST(CancelledBuilding, IsAskedForAgainAndAgain) {
  const auto start = Clock::now();
  std::atomic<Clock::duration> last = Clock::duration::zero(), longest = Clock::duration::zero();
  Monitor monitor;
  monitor.cancelled = [&] {
    const Clock::duration now = Clock::now() - start, gap = now - last.exchange(now);
    if (gap > longest.load()) longest = gap;
    return false;
  };
  const World world(large_beam(), monitor);
  EXPECT_LT(longest.load(), (Clock::now() - start) / 3);
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
