#include "sim/timeline/timeline.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tests/world/scenes.h"

namespace griffith {
namespace {

/// A wall that shots break into pieces that fall, roll and sleep.
Scene scene() {
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.25), 0.5, testing::brick(0.05));
  scene.simulation.time_step = 1.0 / 60;
  return scene;
}

ProjectileBurst shot(double height) {
  ProjectileBurst burst;
  burst.position = Vec3(0.1, height, 2);
  burst.speed = 20;
  return burst;
}

Material weaker(const World& world) {
  Material material = world.frame().materials[0];
  material.tensile_strength *= 0.5;
  return material;
}

TEST(Timeline, EveryStepComesAgainToTheBit) {
  Timeline timeline{World(scene())};
  std::vector<std::uint64_t> hashes = {timeline.world().state_hash()};
  for (int step = 0; step < 60; ++step) {
    if (step == 11 || step == 40) timeline.fire(shot(1.2));
    if (step == 30) timeline.set_material(0, weaker(timeline.world()));
    timeline.advance();
    hashes.push_back(timeline.world().state_hash());
  }
  EXPECT_GT(timeline.world().frame().crack_events.size(), 0u);
  std::mt19937 random(7);
  for (int i = 0; i < 25; ++i) {
    const int step = std::uniform_int_distribution(0, 60)(random);
    timeline.go_to(step);
    EXPECT_EQ(timeline.step(), step);
    EXPECT_EQ(timeline.world().frame().step, step);
    EXPECT_EQ(timeline.world().state_hash(), hashes[static_cast<std::size_t>(step)]) << "at step " << step;
  }
  EXPECT_EQ(timeline.branches().size(), 1u) << "looking back changes nothing";
  EXPECT_EQ(timeline.last_step(), 60);
}

TEST(Timeline, GrabsComeAgainToTheBit) {
  Timeline timeline{World(scene())};
  std::vector<StateHashes> hashes = {timeline.world().state_hashes()};
  for (int step = 0; step < 60; ++step) {
    if (step == 5) timeline.fire(shot(1.2));
    if (step == 20) timeline.grab({.tet = 17, .target = Vec3(0, 2, 1)});
    if (step > 20 && step < 40) timeline.move_grab(Vec3(0.05 * step, 2, 1));
    if (step == 40) timeline.release();
    timeline.advance();
    hashes.push_back(timeline.world().state_hashes());
  }
  EXPECT_EQ(timeline.inputs().size(), 22u);
  for (const int step : {47, 21, 33, 20, 60, 5, 40}) {
    timeline.go_to(step);
    EXPECT_EQ(timeline.world().state_hashes(), hashes[static_cast<std::size_t>(step)]) << "at step " << step;
    EXPECT_EQ(timeline.world().frame().grab.has_value(), step > 20 && step <= 40) << "at step " << step;
  }
  timeline.go_to(30);
  timeline.advance();
  EXPECT_EQ(timeline.world().state_hashes(), hashes[31]);
}

TEST(Timeline, GoingOnFromThePastRepeatsIt) {
  Timeline timeline{World(scene())};
  timeline.advance();
  timeline.fire(shot(1));
  for (int i = 0; i < 30; ++i) timeline.advance();
  const std::uint64_t end = timeline.world().state_hash();
  timeline.go_to(0);
  for (int i = 0; i < 31; ++i) timeline.advance();
  EXPECT_EQ(timeline.world().state_hash(), end);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST(Timeline, AnotherActionInThePastBeginsABranch) {
  Timeline timeline{World(scene())};
  timeline.fire(shot(1));
  for (int i = 0; i < 30; ++i) timeline.advance();
  const std::uint64_t first_end = timeline.world().state_hash();
  timeline.go_to(12);
  const std::uint64_t fork = timeline.world().state_hash();
  timeline.fire(shot(1.6));
  ASSERT_EQ(timeline.branches().size(), 2u);
  EXPECT_EQ(timeline.branch(), 1);
  EXPECT_EQ(timeline.branches()[1].parent, 0);
  EXPECT_EQ(timeline.branches()[1].first_step, 12);
  EXPECT_EQ(timeline.last_step(), 12);
  for (int i = 0; i < 20; ++i) timeline.advance();
  const std::uint64_t second_end = timeline.world().state_hash();
  EXPECT_NE(timeline.world().frame().projectiles.size(), 1u);
  timeline.go_to(12);
  EXPECT_EQ(timeline.world().state_hash(), fork);
  timeline.go_to(5);  // the parent's part
  timeline.go_to(timeline.last_step());
  EXPECT_EQ(timeline.world().state_hash(), second_end);
  timeline.go_to(0, 30);
  EXPECT_EQ(timeline.world().state_hash(), first_end);
  timeline.go_to(1, 32);
  EXPECT_EQ(timeline.world().state_hash(), second_end);
}

TEST(Timeline, ABranchBeforeAnotherActionOfTheSameStepLeavesThatOut) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 4; ++i) timeline.advance();
  timeline.fire(shot(1));
  for (int i = 0; i < 10; ++i) timeline.advance();
  timeline.go_to(4);
  timeline.fire(shot(1.5));
  for (int i = 0; i < 10; ++i) timeline.advance();
  World expected(scene());
  for (int i = 0; i < 4; ++i) expected.step();
  expected.fire(shot(1.5));
  for (int i = 0; i < 10; ++i) expected.step();
  EXPECT_EQ(timeline.world().state_hash(), expected.state_hash());
}

TEST(Timeline, WhatWasDoneLastIsThereWhenItIsCameBackTo) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 9; ++i) timeline.advance();
  timeline.set_material(0, weaker(timeline.world()));
  const Material material = timeline.world().frame().materials[0];
  timeline.go_to(2);
  EXPECT_NE(timeline.world().frame().materials[0], material);
  timeline.go_to(9);
  EXPECT_EQ(timeline.world().frame().materials[0], material);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST(Timeline, MaterialsAreThoseSetAtTheStepThatIsShown) {
  Timeline timeline{World(scene())};
  const Material before = timeline.world().frame().materials[0];
  timeline.advance();
  timeline.set_material(0, weaker(timeline.world()));
  timeline.fire(shot(1));
  const Material material = timeline.world().frame().materials[0];
  timeline.advance();
  timeline.go_to(0);
  EXPECT_EQ(timeline.world().frame().materials[0], before);
  timeline.advance();
  EXPECT_EQ(timeline.world().frame().materials[0], material) << "on the way";
  EXPECT_TRUE(timeline.world().frame().projectiles.empty());
  timeline.go_to(1);
  EXPECT_EQ(timeline.world().frame().materials[0], material);
  EXPECT_TRUE(timeline.world().frame().projectiles.empty());
  timeline.advance();
  EXPECT_EQ(timeline.world().frame().projectiles.size(), 1u);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST(Timeline, AStepIsTakenBackWithWhatWasDoneBeforeIt) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 13; ++i) timeline.advance();
  timeline.fire(shot(1));
  timeline.set_material(0, weaker(timeline.world()));
  const std::uint64_t hash = timeline.world().state_hash();
  const Material material = timeline.world().frame().materials[0];
  std::optional<World> before;
  timeline.advance(&before);
  const std::uint64_t after = timeline.world().state_hash();
  timeline.take_back(std::move(*before));
  EXPECT_EQ(timeline.step(), 13);
  EXPECT_EQ(timeline.world().state_hash(), hash);
  EXPECT_EQ(timeline.world().frame().materials[0], material);
  EXPECT_EQ(timeline.last_step(), 14) << "it stays known";
  timeline.advance();
  EXPECT_EQ(timeline.world().state_hash(), after);
  EXPECT_EQ(timeline.branches().size(), 1u);
}

TEST(Timeline, PlayingUpToThePresentEndsAsItWasLeft) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 9; ++i) timeline.advance();
  timeline.set_material(0, weaker(timeline.world()));
  const Material material = timeline.world().frame().materials[0];
  timeline.go_to(0);
  for (int i = 0; i < 9; ++i) timeline.advance();
  EXPECT_EQ(timeline.world().frame().materials[0], material);
  timeline.fire(shot(1));
  EXPECT_EQ(timeline.branches().size(), 1u) << "it is no past";
}

TEST(Timeline, MarksSayWhereItCracked) {
  Timeline timeline{World(scene())};
  timeline.fire(shot(1));
  for (int i = 0; i < 30; ++i) timeline.advance();
  std::map<std::int64_t, int> cracks;
  for (const CrackEvent& event : timeline.world().frame().crack_events) ++cracks[event.step];
  int marked = 0;
  for (const StepMark& mark : timeline.marks()) marked += mark.cracks;
  EXPECT_EQ(marked, static_cast<int>(timeline.world().frame().crack_events.size()));
  EXPECT_GT(marked, 0);
}

TEST(Timeline, StepsMadeElsewhereLeaveWhatAdvanceLeaves) {
  Timeline whole{World(scene())}, parted = whole;
  const auto advance_both = [&] {
    whole.advance();
    parted.take_step(make_step(parted.before_step()));
    EXPECT_EQ(parted.step(), whole.step());
    EXPECT_EQ(parted.world().state_hash(), whole.world().state_hash()) << whole.step();
  };
  for (Timeline* timeline : {&whole, &parted}) timeline->fire(shot(1));
  for (int i = 0; i < 20; ++i) advance_both();
  for (Timeline* timeline : {&whole, &parted}) timeline->go_to(5);
  for (int i = 0; i < 19; ++i) advance_both();
  EXPECT_EQ(parted.hashes(), whole.hashes());
  EXPECT_EQ(parted.hashes().back(), parted.world().state_hashes());
  EXPECT_EQ(parted.marks().size(), whole.marks().size());
  for (const std::int64_t step : {8, 16, 24}) {
    parted.approach(0, step);
    EXPECT_EQ(parted.step(), step) << "there is a copy";
  }
}

TEST(Timeline, OnlyWhatIsNotKnownOfAStepIsFoundOut) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 7; ++i) {
    EXPECT_TRUE(timeline.before_step().needs.hashes);
    EXPECT_FALSE(timeline.before_step().needs.copy);
    timeline.advance();
  }
  EXPECT_TRUE(timeline.before_step().needs.copy) << "every eighth step";
  MadeStep made = make_step(timeline.before_step());
  EXPECT_TRUE(made.record.copy);
  const std::size_t used = timeline.memory_used();
  timeline.limit_memory(0);
  timeline.take_step(std::move(made));
  EXPECT_EQ(timeline.memory_used(), used) << "no copy is due any more";
  timeline.go_to(3);
  EXPECT_FALSE(timeline.before_step().needs.hashes);
  timeline.go_to(7);
  EXPECT_FALSE(timeline.before_step().needs.copy);
}

TEST(Timeline, RevisionsTellWhetherMoreThanAStepWasDone) {
  Timeline timeline{World(scene())};
  for (int i = 0; i < 4; ++i) timeline.advance();
  timeline.fire(shot(1));
  timeline.go_to(1);
  for (int step = 2; step <= 4; ++step) {
    const std::int64_t before = timeline.revision();
    timeline.advance();
    EXPECT_EQ(timeline.revision() == before + 1, step < 4) << "the shot comes after step 4";
  }
}

TEST(Timeline, CopiesKeepToTheMemoryAllowed) {
  const World world(scene());
  const std::size_t one = world.memory();
  EXPECT_GT(one, 10'000u);
  Timeline timeline(world, 6 * one);
  timeline.fire(shot(1));
  std::vector<std::uint64_t> hashes = {timeline.world().state_hash()};
  for (int i = 0; i < 100; ++i) {
    timeline.advance();
    hashes.push_back(timeline.world().state_hash());
    EXPECT_LE(timeline.memory_used(), 6 * one);
  }
  EXPECT_GT(timeline.interval(), 8);
  for (const int step : {77, 3, 100, 50}) {
    timeline.go_to(step);
    EXPECT_EQ(timeline.world().state_hash(), hashes[static_cast<std::size_t>(step)]);
  }
}

TEST(Timeline, WhatCopiesShareCountsOnce) {
  World world(scene());
  const World copy = world;
  EXPECT_LT(copy.memory(&world), 2 * copy.memory() / 3) << "nothing of it has changed";
  world.step();
  EXPECT_GT(world.memory(&copy), copy.memory(&copy));
  EXPECT_LT(world.memory(&copy), world.memory());
  Timeline timeline(copy);
  for (int i = 0; i < 16; ++i) timeline.advance();
  EXPECT_GT(timeline.memory_used(), timeline.world().memory());
  EXPECT_LT(timeline.memory_used(), 3 * timeline.world().memory()) << "of the start, steps 8 and 16";
}

TEST(Timeline, WhatIsRefusedIsNoPartOfThePast) {
  Scene explicitly = scene();
  explicitly.simulation.integrator = Integrator::explicit_;
  Timeline timeline{World(explicitly)};
  Material stiff = timeline.world().frame().materials[0];
  stiff.young_modulus = 1e13;
  stiff.density = 1e-3;
  EXPECT_THROW(timeline.set_material(0, stiff), InputError);
  EXPECT_TRUE(timeline.branches()[0].inputs.empty());
}

TEST(Timeline, ApproachAndStepsLeadWhereGoToLeads) {
  Timeline timeline{World(scene())};
  timeline.fire(shot(1));
  std::vector<std::uint64_t> hashes = {timeline.world().state_hash()};
  for (int i = 0; i < 40; ++i) {
    timeline.advance();
    hashes.push_back(timeline.world().state_hash());
  }
  timeline.limit_memory(0);
  EXPECT_GT(timeline.interval(), 40) << "no copy is left but the first";
  for (const std::int64_t wanted : {30, 0, 40, 12, 13, 40}) {
    const std::int64_t step = timeline.approach(0, wanted);
    EXPECT_EQ(step, wanted);
    EXPECT_LE(timeline.step(), wanted);
    while (timeline.step() < step) timeline.advance();
    EXPECT_EQ(timeline.world().state_hash(), hashes[static_cast<std::size_t>(wanted)]) << wanted;
  }
  EXPECT_EQ(timeline.approach(0, 1000), 40) << "no further than there is";
}

TEST(Timeline, ImpactsAreMarkedWhereSomethingIsStruck) {
  Timeline timeline{World(scene())};
  timeline.fire(shot(1));
  int impacts = 0;
  std::int64_t first = 0;
  for (int i = 0; i < 30; ++i) timeline.advance();
  for (const StepMark& mark : timeline.marks()) {
    if (impacts == 0 && mark.impacts > 0) first = mark.step;
    impacts += mark.impacts;
  }
  EXPECT_GE(impacts, 1);
  // 2 m less half the wall and the ball's radius, at 20 m/s in steps of 1/60 s.
  EXPECT_NEAR(static_cast<double>(first), (2 - 0.125 - 0.2) / 20 * 60, 1.5);
}

}  // namespace
}  // namespace griffith
