#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

/// A wall of 2,160 tetrahedra, of which a step takes longer than it may in a short frame.
Scene slow_wall() {
  Scene scene = small_wall();
  std::get<BoxShape>(scene.bodies[0].shape).element_size = Vec3::Constant(1.0 / 6);
  return scene;
}

/// Compares pictures without shards.
void expect_same(const render::DrawScene& picture, const render::DrawScene& expected) {
  EXPECT_EQ(picture.surface.positions, expected.surface.positions);
  EXPECT_EQ(picture.surface.scalars, expected.surface.scalars);
  EXPECT_EQ(picture.surface.ids, expected.surface.ids);
  EXPECT_EQ(picture.surface.flags, expected.surface.flags);
  EXPECT_EQ(picture.surface.scalar_style.quantity, expected.surface.scalar_style.quantity);
  EXPECT_EQ(picture.spheres.size(), expected.spheres.size());
  EXPECT_EQ(picture.labels.size(), expected.labels.size());
  EXPECT_EQ(picture.glyphs.arrows.size(), expected.glyphs.arrows.size());
}

/// The editor as its window has it: steps that take long go on while it draws.
class PaceTest : public EditorTest {
 protected:
  PaceTest() : EditorTest(slow_wall()) { editor_.run().step_in_background(); }

  /// A frame so short that a step that begins in it hardly ever ends in it.
  void begin_step() {
    editor_.state().running = true;
    editor_.state().speed = 20;
    editor_.run().advance(1e-3);
  }
  /// Waits until the step in the background has ended, without taking it, a minute at most.
  void await_step() const {
    ui::EditorInput input;
    for (int i = 0; i < 60'000; ++i) {
      editor_.run().describe(input);
      if (input.step_in_progress == 0) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL() << "the step does not end";
  }
  /// Lets short frames pass until that step is there.
  void run_to(std::int64_t step) {
    begin_step();
    for (int i = 0; i < 60'000 && editor_.run().frame().step < step && editor_.state().running; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      editor_.run().advance(1e-3);
    }
    editor_.state().running = false;
    draw();
  }
  /// Checks that the picture shows the present state and view, after the world has caught up.
  void expect_picture_of_what_is_shown() {
    draw(2);
    const ui::EditorState& state = editor_.state();
    const render::DrawScene expected =
        draw_scene_from_frame(editor_.run().frame(), {}, editor_.document().scene(), state.view, state.selection,
                              std::nullopt, state.hidden_bodies.empty() ? HiddenBodies{} : HiddenBodies{0});
    expect_same(editor_.viewport().picture(), expected);
  }
  std::uint64_t hash() const { return editor_.run().timeline().world().state_hash(); }
  void fire() {
    editor_.state().shot.speed = 60;
    editor_.execute({.name = "simulation.fire"});
  }
  std::int64_t step() const { return editor_.run().frame().step; }
};

TEST_F(PaceTest, StepsInTheBackgroundLeaveWhatStepsInTurnLeave) {
  World world(slow_wall());
  run_to(12);
  while (world.frame().step < step()) world.step();
  EXPECT_GE(step(), 12);
  EXPECT_EQ(hash(), world.state_hash());
}

TEST_F(PaceTest, WhileAStepLastsTheWindowDrawsAtMostItsProgress) {
  begin_step();
  if (editor_.run().waits_for_step()) {
    EXPECT_GT(editor_.seconds_to_next_frame(), 0);
  }
  await_step();
  EXPECT_EQ(editor_.seconds_to_next_frame(), 0) << "it is there";
  editor_.state().running = false;
}

TEST(BackgroundStep, TellsWhenAStepCanBeTaken) {
  std::promise<void> ended;
  BackgroundStep background;
  background.call_when_done([&] { ended.set_value(); });
  background.begin({World(slow_wall()), {}}, std::nullopt, {0, 0});
  ASSERT_EQ(ended.get_future().wait_for(std::chrono::minutes(1)), std::future_status::ready);
  EXPECT_FALSE(background.in_progress());
  EXPECT_TRUE(background.wait_until(BackgroundStep::Clock::time_point::min()));
}

TEST_F(PaceTest, AShotMeanwhileComesBeforeTheStepThatWasOnItsWay) {
  run_to(3);
  begin_step();
  fire();
  editor_.state().running = false;
  const std::int64_t fired_at = step();
  ASSERT_EQ(editor_.run().timeline().inputs().back().step, fired_at);
  run_to(fired_at + 4);
  World world(slow_wall());
  while (world.frame().step < fired_at) world.step();
  world.fire(std::get<ProjectileBurst>(editor_.run().timeline().inputs().back().action));
  while (world.frame().step < step()) world.step();
  EXPECT_EQ(hash(), world.state_hash());
}

TEST_F(PaceTest, GoingBackMeanwhileIsNotUndoneByTheStepThatEnds) {
  run_to(8);
  begin_step();
  editor_.execute({.name = "time.step", .step = 2});
  await_step();
  draw(3);
  EXPECT_EQ(step(), 2);
  editor_.run().step();
  EXPECT_EQ(step(), 3);
  run_to(8);
  World world(slow_wall());
  while (world.frame().step < step()) world.step();
  EXPECT_EQ(hash(), world.state_hash());
}

TEST_F(PaceTest, AnotherSceneMeanwhileIsNotGivenTheStepOfTheLast) {
  run_to(4);
  begin_step();
  editor_.builder().open(small_wall_file());
  wait_for_work();
  EXPECT_EQ(step(), 0);
  run_to(4);
  World world(small_wall());
  while (world.frame().step < step()) world.step();
  EXPECT_EQ(hash(), world.state_hash());
}

TEST_F(PaceTest, StopsBeforeACrackAllTheSame) {
  editor_.state().breakpoints.crack = ui::Breakpoints::Where::anywhere;
  run_to(200);
  ASSERT_TRUE(editor_.state().stop);
  EXPECT_TRUE(editor_.run().frame().crack_events.empty());
  World world(slow_wall());
  while (world.frame().step < step()) world.step();
  EXPECT_EQ(hash(), world.state_hash());
  EXPECT_TRUE(world.frame().crack_events.empty());
  world.step();
  EXPECT_FALSE(world.frame().crack_events.empty());
}

/// A window that has room for all numbers, with a clock on which pictures and steps take as long as is said.
class ClockTest : public EditorTest {
 protected:
  ClockTest() : EditorTest(small_wall(), 1900) {}
};

TEST_F(ClockTest, TheSpeedsShownAreThoseOfTheClock) {
  for (const double cost : {0.05, 2.8}) {  // of a step [s]
    editor_.state().running = false;
    click("command/simulation.run");
    const double picture = 0.02, time_step = editor_.document().scene().simulation.time_step;
    std::vector<std::pair<double, double>> frames;  // how long each took [s], and what it simulated [s]
    frames.emplace_back(picture, 0);
    for (int i = 0; i < 30; ++i) {
      const double before = editor_.run().frame().time;
      editor_.run().advance(frames.back().first);
      const double made = editor_.run().frame().time - before;
      frames.emplace_back(picture + cost * made / time_step, made);
    }
    draw();
    frames.pop_back();  // the clock has not come to its end
    double clock = 0, simulated = 0, pictures = 0;
    for (auto frame = frames.rbegin(); frame != frames.rend() && clock < 2; ++frame, ++pictures) {
      clock += frame->first;
      simulated += frame->second;
    }
    EXPECT_NEAR(std::stod(value("toolbar/speed_reached")), simulated / clock, 0.1 * simulated / clock) << cost;
    EXPECT_NEAR(std::stod(value("toolbar/pictures")), pictures / clock, 0.1 * pictures / clock) << cost;
  }
}

TEST(BackgroundStep, MakesTheStepOfACopyForItsStartAlone) {
  using Clock = BackgroundStep::Clock;
  const World world(slow_wall());
  World stepped = world;
  stepped.step();
  BackgroundStep background;
  EXPECT_FALSE(background.pending());
  EXPECT_EQ(background.age(), 0);
  background.begin({world, {}}, std::nullopt, {1, 7});
  EXPECT_TRUE(background.fits({1, 7}));
  EXPECT_FALSE(background.fits({1, 8}));
  EXPECT_FALSE(background.fits({2, 7}));
  EXPECT_TRUE(background.wait_until(Clock::time_point::max()));
  EXPECT_EQ(background.age(), 0);
  const BackgroundStep::Made made = background.take();
  EXPECT_EQ(made.step.world.state_hash(), stepped.state_hash());
  EXPECT_FALSE(made.picture) << "none was asked for";
  EXPECT_FALSE(background.pending());
}

TEST(BackgroundStep, DrawsThePictureThatStepsInTurnHave) {
  const Scene scene = slow_wall();
  World world(scene);
  const Frame start = world.frame();
  const ui::Selection selection = ui::select(start, TetId(7), start.elements.tets[7][2]);
  CopyOnWrite display(embedded_display(start, scene));
  SteadyRange range;
  StepPicture picture{{scene, scene.view, selection, {}}, display, range};
  BackgroundStep background;
  for (int step = 1; step < 4; ++step) {
    background.begin({world, {}}, std::move(picture), {0, step});
    world.step();
    const render::DrawScene expected =
        draw_next_step(world.frame(), display, range, scene, scene.view, ui::follow(selection, world.frame()));
    picture = std::move(*background.take().picture);
    expect_same(picture.drawn, expected);
    EXPECT_TRUE(*picture.range.range() == *range.range());
    EXPECT_TRUE(picture.display.shares_with(display)) << "nothing has cracked";
  }
}

TEST_F(PaceTest, EachPictureIsOfTheStateShown) {
  select_node(editor_.state(), editor_.run().frame(), NodeId(40));
  for (std::int64_t wanted = 1; wanted < 8; ++wanted) {
    run_to(wanted);
    expect_picture_of_what_is_shown();
    begin_step();
    expect_picture_of_what_is_shown();  // the last one, while the next is on its way
  }
}

TEST_F(PaceTest, AViewChangedMeanwhileIsThatOfThePicture) {
  const auto change_during_a_step = [this](auto change) {
    begin_step();
    change();
    expect_picture_of_what_is_shown();
    run_to(step() + 1);
    expect_picture_of_what_is_shown();
  };
  run_to(2);
  change_during_a_step([this] { editor_.state().view.quantity = "speed"; });
  change_during_a_step([this] { editor_.state().view.layers = {ViewLayer::velocities}; });
  change_during_a_step([this] { select_node(editor_.state(), editor_.run().frame(), NodeId(25)); });
  change_during_a_step([this] { editor_.state().selection = {}; });
  change_during_a_step([this] { editor_.state().hidden_bodies.insert(editor_.document().scene().bodies[0].name); });
  EXPECT_TRUE(editor_.viewport().picture().surface.positions.empty());
}

TEST_F(PaceTest, AChangedMaterialMeanwhileIsInThePicture) {
  run_to(3);
  begin_step();
  choose_material("concrete");
  expect_picture_of_what_is_shown();
  run_to(step() + 2);
  expect_picture_of_what_is_shown();
  begin_step();
  editor_.execute({.name = "edit.undo"});
  expect_picture_of_what_is_shown();
  run_to(step() + 2);
  expect_picture_of_what_is_shown();
}

TEST_F(PaceTest, GoingBackOrToAnotherSceneMeanwhileShowsThat) {
  run_to(6);
  begin_step();
  editor_.execute({.name = "time.step", .step = 2});
  await_step();
  expect_picture_of_what_is_shown();
  run_to(4);
  expect_picture_of_what_is_shown();
  begin_step();
  editor_.builder().open(small_wall_file());
  wait_for_work();
  expect_picture_of_what_is_shown();
  run_to(3);
  expect_picture_of_what_is_shown();
}

TEST_F(PaceTest, WhatWasDoneAfterTheLastStepIsInItsPictureWhenItComesAgain) {
  run_to(4);
  const std::int64_t last = step();
  choose_material("concrete");
  const Material material = editor_.run().frame().materials[0];
  editor_.execute({.name = "time.step", .step = 1});
  ASSERT_NE(editor_.run().frame().materials[0], material);
  begin_step();
  for (int i = 0; i < 60'000 && step() < last; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    editor_.run().advance(1e-3);
  }
  editor_.state().running = false;
  ASSERT_EQ(step(), last);
  EXPECT_EQ(editor_.run().frame().materials[0], material);
  expect_picture_of_what_is_shown();
}

TEST_F(PaceTest, ASceneGoesOnWhileASliderIsHeld) {
  run_to(2);
  const ui::WidgetTag* slider = ui::find_tag(editor_.tags(), "material/density");
  ASSERT_TRUE(slider);
  const ImVec2 place = slider->center();
  queue_.move(place);
  play();
  queue_.button(0, true);
  play();
  editor_.state().running = true;
  for (int i = 1; i < 60'000 && step() < 6; ++i) {
    editor_.run().advance(1e-3);
    queue_.move({place.x + static_cast<float>(i % 40), place.y});  // another value in every frame
    play();
  }
  EXPECT_GE(step(), 6);
  EXPECT_GT(editor_.run().timeline().inputs().size(), 2u) << "and steps have the values of their time";
  editor_.state().running = false;
  queue_.button(0, false);
  play();
}

}  // namespace
}  // namespace griffith::app
