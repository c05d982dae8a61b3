// Microsteps of a step, as they are recorded for playback.

#include "sim/timeline/microstep_recording.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/core/parallel.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

/// A pane that a ball breaks, and a box far away that flies on.
Scene broken_pane() {
  Scene scene = testing::shot_pane(5, 1.0 / 120);
  BodyDescription box;
  box.position = Vec3(20, 0, 0);
  box.velocity = Vec3(0, 3, 0);
  box.angular_velocity = Vec3(0, 0, 2);
  scene.bodies.push_back(box);
  return scene;
}

/// Returns the world before the step in which the first crack opens.
World before_first_crack(const Scene& scene) {
  World world(scene), before = world;
  while (world.frame().crack_events.empty()) {
    before = world;
    world.step();
  }
  return before;
}

MicrostepRecording recorded(World before, const MicrostepRange& range = {}, std::size_t memory = kUnlimited) {
  MicrostepRecording recording(range, memory);
  before.step(recording.observer());
  return recording;
}

/// Makes both worlds step, one of them observed, and compares all that they keep.
void expect_same_bits_if_observed(const Scene& scene, int interval, int steps) {
  World plain(scene), observed = plain;
  for (int step = 0; step < steps; ++step) {
    plain.step();
    MicrostepRecording recording({.interval = interval}, kUnlimited);
    observed.step(recording.observer());
    ASSERT_EQ(plain.state_hashes(), observed.state_hashes()) << step;
  }
  EXPECT_FALSE(plain.frame().crack_events.empty());
}

TEST(MicrostepRecording, AnObservedRunHasTheSameBits) {
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.25), 0.5, testing::brick(0.05));
  scene.simulation.time_step = 1.0 / 60;
  scene.simulation.integrator = Integrator::hybrid;
  expect_same_bits_if_observed(scene, 1, 12);
}

/// Explicit integration, whose every substep is a microstep, on fewer elements.
TEST(MicrostepRecording, AnObservedExplicitRunHasTheSameBits) {
  Scene scene = testing::shot_wall(Vec3(1, 1, 0.25), 0.5, testing::brick(0.05));
  scene.simulation.time_step = 1.0 / 60;
  scene.simulation.integrator = Integrator::explicit_;
  expect_same_bits_if_observed(scene, 3, 8);
}

TEST(MicrostepRecording, MomentsLeadFromTheStateBeforeToTheStateAfter) {
  const World before = before_first_crack(broken_pane());
  World after = before;
  after.step();
  const MicrostepRecording recording = recorded(before);
  ASSERT_GT(recording.moments().size(), 20u);
  EXPECT_EQ(static_cast<int>(recording.moments().size()), after.frame().report.microsteps);
  double time = before.frame().time;
  std::size_t cracks = before.frame().crack_events.size();
  int pieces = 0;
  for (const MicrostepRecording::Moment& moment : recording.moments()) {
    const Frame frame = moment.world.frame();
    EXPECT_GT(frame.time, time);
    EXPECT_GE(frame.crack_events.size(), cracks);
    EXPECT_GE(frame.fragments, pieces);
    for (const CrackEvent& crack : frame.crack_events.subspan(cracks)) EXPECT_LE(crack.time, frame.time);
    time = frame.time, cracks = frame.crack_events.size(), pieces = frame.fragments;
  }
  EXPECT_LE(time, after.frame().time * (1 + 1e-12));
  EXPECT_EQ(cracks, after.frame().crack_events.size());
  EXPECT_EQ(pieces, after.frame().fragments);
  EXPECT_GT(pieces, 0);
}

TEST(MicrostepRecording, MomentumIsThatOfTheStateBeforeInEachMoment) {
  const World before = before_first_crack(broken_pane());
  const Vec3 momentum = before.frame().totals.momentum;
  const MicrostepRecording recording = recorded(before, {.interval = 7});
  for (const MicrostepRecording::Moment& moment : recording.moments())
    EXPECT_LT((moment.world.frame().totals.momentum - momentum).norm(), 1e-9 * momentum.norm());
}

TEST(MicrostepRecording, ObjectsElsewhereAreShownAtTheSameTime) {
  const World before = before_first_crack(broken_pane());
  const BodyView start = before.frame().bodies[1];
  const double start_time = before.frame().time;
  const MicrostepRecording recording = recorded(before, {.interval = 7});
  for (const MicrostepRecording::Moment& moment : recording.moments()) {
    const Frame frame = moment.world.frame();
    const double flown = frame.time - start_time;
    const BodyView& box = frame.bodies[1];
    EXPECT_LT((box.center_of_mass - start.center_of_mass - flown * start.velocity).norm(), 1e-9);
    EXPECT_NEAR(box.orientation.angularDistance(start.orientation), 2 * flown, 1e-6);
    const NodeId corner = frame.elements.tets.back()[0];
    const Vec3 arm = frame.nodes.rest_positions[corner] - Vec3(20, 0, 0);
    EXPECT_LT((frame.nodes.positions[corner] - box.center_of_mass - box.orientation * arm).norm(), 1e-6);
  }
}

TEST(MicrostepRecording, AFinerRecordingHasTheSameMoments) {
  const World before = before_first_crack(broken_pane());
  const MicrostepRecording coarse = recorded(before, {.interval = 16});
  const std::int64_t first = coarse.moments()[1].microstep;
  const MicrostepRecording fine = recorded(before, {first, first + 32, 1});
  ASSERT_EQ(fine.moments().size(), 33u);
  for (int i = 0; i < 3; ++i) {
    const auto& [microstep, world] = fine.moments()[16 * i];
    EXPECT_EQ(microstep, coarse.moments()[1 + i].microstep);
    EXPECT_EQ(world.state_hashes(), coarse.moments()[1 + i].world.state_hashes());
  }
}

TEST(MicrostepRecording, MomentsDoNotDependOnTheNumberOfThreads) {
  const World before = before_first_crack(broken_pane());
  std::vector<StateHashes> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    hashes.push_back(recorded(before, {.interval = 16}).moments()[3].world.state_hashes());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(MicrostepRecording, KeepsToItsMemoryAtEqualIntervals) {
  const World before = before_first_crack(broken_pane());
  const std::size_t whole = recorded(before).memory_used();
  for (const std::size_t memory : {whole / 3, whole / 20}) {
    const MicrostepRecording recording = recorded(before, {}, memory);
    EXPECT_LE(recording.memory_used(), memory);
    EXPECT_GT(recording.interval(), 1);
    for (std::size_t i = 1; i < recording.moments().size(); ++i)
      EXPECT_EQ(recording.moments()[i].microstep - recording.moments()[i - 1].microstep, recording.interval());
    EXPECT_GT(recording.moments().back().microstep + recording.interval(), recording.microsteps()) << "to the end";
  }
  EXPECT_EQ(recorded(before, {}, 1).moments().size(), 2u);
}

TEST(MicrostepRecording, UndoneMicrostepsAreForgotten) {
  const World world(broken_pane());
  MicrostepRecording recording({.interval = 2}, kUnlimited);
  const MicrostepObserver observer = recording.observer();
  const auto make = [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i <= last; ++i)
      if (observer.wants(i)) observer.take(i, world);
  };
  make(1, 9);
  observer.undo(4);
  make(5, 6);
  std::vector<std::int64_t> kept;
  for (const MicrostepRecording::Moment& moment : recording.moments()) kept.push_back(moment.microstep);
  EXPECT_EQ(kept, (std::vector<std::int64_t>{1, 3, 5}));
  EXPECT_EQ(recording.microsteps(), 6);
}

TEST(MicrostepRecording, CountsThemWithoutRecording) {
  const World before = before_first_crack(broken_pane());
  EXPECT_EQ(count_microsteps(before), recorded(before).microsteps());
  EXPECT_EQ(count_microsteps(World(broken_pane())), 0) << "nothing is struck yet";
}

TEST(MicrostepRecording, IsCancelledAtTheNextMicrostep) {
  int left = 5;
  MicrostepRecording recording({}, kUnlimited, [&] { return left-- == 0; });
  World world = before_first_crack(broken_pane());
  EXPECT_THROW(world.step(recording.observer()), Cancelled);
  EXPECT_EQ(recording.moments().size(), 5u);
}

}  // namespace
}  // namespace griffith
