#include "sim/recording/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "recorded_scenes.h"
#include "sim/core/parallel.h"
#include "tests/files/test_folder.h"

namespace griffith {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;
using namespace griffith::testing;

/// Returns the first step that differs when all are repeated.
std::optional<ReplayDifference> difference_of(const Recording& recording) {
  Replay replay(recording);
  while (!replay.at_end() && !replay.difference()) replay.advance();
  return replay.difference();
}

/// Returns a text for a failing test.
std::string text_of_difference(const std::optional<ReplayDifference>& difference) {
  if (!difference) return "none";
  std::string text = "step " + std::to_string(difference->step) + ":";
  for (const std::string_view field : difference->fields) text.append(" ").append(field);
  return text;
}

TEST(Replay, MakesEverySceneAgainWithAnyNumberOfThreads) {
  const auto folder = empty_folder();
  setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
  for (const auto& [name, scene, steps] : recorded_scenes(folder)) {
    const Recording recording = through_file(record(played(scene, steps)), folder);
    ASSERT_EQ(recording.steps(), steps);
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(text_of_difference(difference_of(recording)), "none") << name << " with " << threads << " threads";
    }
  }
}

TEST(Replay, NeedsNothingOfWhereItWasRecorded) {
  const auto folder = empty_folder();
  setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
  std::vector<Recording> recordings;
  std::filesystem::create_directories(folder / "there");
  for (const auto& [name, scene, steps] : recorded_scenes(folder / "there"))
    recordings.push_back(through_file(record(played(scene, 10)), folder));
  std::filesystem::remove_all(folder / "there");
  std::filesystem::remove_all(folder / "cache");
  const std::string path = std::getenv("PATH");
  setenv("PATH", "", 1);  // without TetGen: the mesh that filled a surface is recorded
  for (const Recording& recording : recordings) EXPECT_EQ(text_of_difference(difference_of(recording)), "none");
  setenv("PATH", path.c_str(), 1);
}

TEST(Replay, FollowsTheBranchThatIsRecorded) {
  const auto folder = empty_folder();
  Timeline timeline = played(struck_wall(), 14);
  const Recording first = through_file(record(timeline), folder);
  timeline.go_to(6);
  ProjectileBurst shot;
  shot.position = Vec3(0.4, 0.6, 1);
  timeline.fire(shot);
  for (int i = 0; i < 6; ++i) timeline.advance();
  timeline.go_to(2);
  const Recording second = through_file(record(timeline), folder);
  EXPECT_EQ(first.steps(), 14);
  EXPECT_EQ(second.steps(), 12);
  EXPECT_EQ(second.inputs.size(), 2u) << "the shot at step 4, and that of the branch";
  EXPECT_EQ(first.hashes[6], second.hashes[6]);
  EXPECT_NE(first.hashes[8], second.hashes[8]);
  EXPECT_EQ(text_of_difference(difference_of(first)), "none");
  EXPECT_EQ(text_of_difference(difference_of(second)), "none");
}

TEST(Replay, ATimelineIsBackWhereItsHashesSay) {
  Timeline timeline = played(struck_wall(), 20);
  const std::vector<StateHashes> hashes = timeline.hashes();
  ASSERT_EQ(hashes.size(), 21u);
  for (const int step : {20, 3, 17, 8, 0, 13}) {  // at the others there were inputs since
    timeline.go_to(step);
    EXPECT_EQ(timeline.world().state_hashes(), hashes[static_cast<std::size_t>(step)]) << step;
  }
}

TEST(Replay, ReportsTheFirstStepAndTheFieldsThatDiffer) {
  Recording recording = record(played(struck_wall(), 16));
  recording.hashes[11][6] ^= 1;
  recording.hashes[13][0] ^= 1;
  const auto difference = difference_of(recording);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->step, 11);
  EXPECT_THAT(difference->fields, ElementsAre("bodies"));
}

TEST(Replay, FindsAnotherShotInTheStepAfterIt) {
  Recording recording = record(played(struck_wall(), 16));
  std::get<ProjectileBurst>(recording.inputs[0].action).speed *= 1 + 1e-15;
  const auto difference = difference_of(recording);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->step, 5) << "it was fired before this step";
  EXPECT_THAT(difference->fields, Contains("projectiles"));
  EXPECT_THAT(difference->fields, Not(Contains("positions"))) << "it has not struck yet";
}

TEST(Replay, FindsAnotherMaterialInTheStepAfterIt) {
  Scene scene = struck_wall();
  scene.bodies[0].elements = ElementOrder::linear;
  Recording recording = record(played(scene, 16));
  std::get<MaterialChange>(recording.inputs[1].action).material.young_modulus *= 1.5;
  const auto difference = difference_of(recording);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->step, 10);
  EXPECT_THAT(difference->fields, Contains("stresses"));
  EXPECT_THAT(difference->fields, Contains("velocities"));
}

TEST(Replay, FindsAnotherStart) {
  Recording recording = record(played(struck_wall(), 3));
  recording.scene.bodies[0].position.x() += 1e-9;
  const auto difference = difference_of(recording);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->step, 0);
  EXPECT_THAT(difference->fields, Contains("mesh"));
}

}  // namespace
}  // namespace griffith
