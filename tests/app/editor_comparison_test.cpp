#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/editor/compared_branch.h"
#include "editor_fixture.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

/// A wall that was let alone for ten steps, and one into which a ball was fired after four.
Timeline forked() {
  Scene scene = small_wall();
  scene.projectiles.clear();
  Timeline timeline{World(scene)};
  while (timeline.step() < 10) timeline.advance();
  timeline.go_to(4);
  ProjectileBurst shot;
  shot.position = Vec3(0, 1.2, 1);
  shot.speed = 60;
  timeline.fire(shot);
  while (timeline.step() < 10) timeline.advance();
  return timeline;
}

TEST(Divergence, IsFoundInTheFirstStepThatDiffers) {
  const Timeline shot = forked();
  Timeline alone = shot;
  alone.go_to(0, 10);
  const std::optional<Divergence> divergence = first_divergence(shot, alone);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->step, 5) << "the ball was there from step 4 on";
  EXPECT_DOUBLE_EQ(divergence->time, 5 * alone.world().scene().simulation.time_step);
  const std::optional<Divergence> mirrored = first_divergence(alone, shot);
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->step, divergence->step);
  EXPECT_EQ(mirrored->gap.distance, divergence->gap.distance);
  EXPECT_FALSE(first_divergence(shot, shot));
}

TEST(Divergence, TheLargestGapIsThatOfTheNodeWhichIsFarthestOff) {
  Timeline shot = forked(), alone = shot;
  alone.go_to(0, 10);
  const Frame a = shot.world().frame(), b = alone.world().frame();
  const Gap gap = largest_gap(a, b);
  EXPECT_GT(gap.distance, 0);
  EXPECT_EQ(gap.scene_body, 0);
  for (std::size_t node = 0; node < b.nodes.positions.size(); ++node)
    EXPECT_LE((a.nodes.positions[node] - b.nodes.positions[node]).norm(), gap.distance);
  EXPECT_EQ(largest_gap(a, a).scene_body, -1);
  EXPECT_EQ(largest_gap(a, a).distance, 0);
}

class ComparisonTest : public EditorTest {
 protected:
  void run(int steps) {
    for (int i = 0; i < steps; ++i) editor_.run().step();
    draw(2);
  }
  /// A second branch, with a shot in step 3 of ten.
  void fork() {
    run(10);
    editor_.execute({.name = "time.step", .step = 3});
    editor_.state().shot.speed = 200;
    editor_.execute({.name = "simulation.fire"});
    run(7);
  }
};

TEST_F(ComparisonTest, NeedsAnotherBranch) {
  run(3);
  EXPECT_FALSE(editor_.disabled_reason("time.compare").empty());
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/compare"));
}

TEST_F(ComparisonTest, TheOtherBranchFollowsTheShownStep) {
  fork();
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  press_key('B');
  draw(2);
  ASSERT_TRUE(editor_.state().comparison.branch);
  EXPECT_EQ(*editor_.state().comparison.branch, 0);
  EXPECT_THAT(value("compare/difference"), HasSubstr("Branch 0 differs from step 4"));
  EXPECT_THAT(value("compare/difference"), HasSubstr("apart"));
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash) << "what is shown is not touched by it";
  editor_.execute({.name = "time.step", .step = 2});
  draw(2);
  EXPECT_THAT(value("compare/difference"), HasSubstr("Now all nodes are in the same places"));
  run(12);  // beyond the end of the other, which runs on
  for (int i = 0; i < 600 && editor_.analysis().computes_comparison(); ++i) draw();
  EXPECT_EQ(editor_.state().comparison.step, editor_.run().frame().step);
  EXPECT_THAT(value("compare/difference"), HasSubstr("apart"));
  EXPECT_EQ(editor_.run().timeline().branches()[0].last_step, 10) << "it is computed apart from the recorded past";
  press_key('B');
  EXPECT_FALSE(editor_.state().comparison.branch);
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "compare/difference"));
}

TEST_F(ComparisonTest, BothBranchesAreDrawnInTheSameQuality) {
  editor_.state().view.quality = PictureQuality::standard;  // the test limits it to drafts
  fork();
  editor_.execute({.name = "time.step", .step = 2});  // where both are the same
  draw(2);
  const ImVec2 center = ui::find_tag(editor_.tags(), "viewport")->center();
  const auto middle = [&] {
    constexpr int kSide = 200;
    return render::part_of(window_image(), static_cast<int>(center.x) - kSide / 2,
                           static_cast<int>(center.y) - kSide / 2, kSide, kSide);
  };
  const render::Image alone = middle();
  press_key('B');
  editor_.state().comparison.border = 0.02F;
  draw(3);
  ASSERT_TRUE(editor_.state().comparison.branch);
  const render::Image compared = middle();
  ASSERT_EQ(compared.rgba.size(), alone.rgba.size());
  int largest = 0;
  for (std::size_t i = 0; i < alone.rgba.size(); ++i)
    largest = std::max(largest, std::abs(int{compared.rgba[i]} - int{alone.rgba[i]}));
  EXPECT_LE(largest, 2) << "the picture is placed by interpolation";
}

TEST_F(ComparisonTest, GoingToTheComparedBranchLetsTheTwoChangePlaces) {
  fork();
  click("time/compare");
  draw(2);
  click("compare/0");
  draw(2);
  ASSERT_EQ(editor_.state().comparison.branch, 0);
  press_key(ui::key::kEscape);
  editor_.execute({.name = "time.branch", .step = 8, .branch = 0});
  draw(2);
  EXPECT_EQ(editor_.run().timeline().branch(), 0);
  EXPECT_EQ(editor_.state().comparison.branch, 1);
  EXPECT_THAT(value("compare/difference"), HasSubstr("Branch 1 differs from step 4"));
}

TEST_F(ComparisonTest, ABranchThatBeginsMeanwhileIsComparedAgain) {
  fork();
  click("time/compare");
  draw(2);
  click("compare/0");
  draw(2);
  press_key(ui::key::kEscape);
  EXPECT_THAT(value("compare/difference"), HasSubstr("Branch 0 differs from step 4"));
  editor_.execute({.name = "time.step", .step = 2});
  editor_.execute({.name = "simulation.fire"});
  run(3);
  ASSERT_EQ(editor_.run().timeline().branch(), 2);
  EXPECT_THAT(value("compare/difference"), HasSubstr("Branch 0 differs from step 3"));
}

TEST_F(ComparisonTest, PlotsShowTheValuesOfBothBranches) {
  fork();
  press_key('B');
  press_key('P');
  draw(3);
  const ui::WidgetTag* strip = ui::find_tag(editor_.tags(), "plots/strip/0");
  ASSERT_TRUE(strip);
  queue_.move({strip->maximum.x - 10, strip->center().y});
  play();
  draw(2);
  EXPECT_THAT(value("plots/value/energy.kinetic"), HasSubstr(" | branch 0: "));
}

TEST_F(ComparisonTest, AnotherSceneEndsIt) {
  fork();
  press_key('B');
  draw(2);
  editor_.builder().open(small_wall_file());
  wait_for_work();
  EXPECT_FALSE(editor_.state().comparison.branch);
}

}  // namespace
}  // namespace griffith::app
