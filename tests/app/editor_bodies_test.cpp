#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/editor/new_entry.h"
#include "editor_fixture.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

constexpr std::string_view kAdded[] = {"add.box", "add.plate", "add.pane", "add.cylinder", "add.sphere", "add.beam"};

class BodiesTest : public EditorTest {
 protected:
  void begin() {
    editor_.execute({.name = "file.new", .discard_edits = true});
    settle();
  }
  void add(std::string_view name) {
    editor_.execute({.name = name});
    settle();
  }
  void settle() {
    draw(2);
    wait_for_work();
  }
  std::size_t bodies() const { return editor_.run().frame().bodies.size(); }
  std::string file(const char* name) const { return (test_folder() / name).string(); }
  std::string text_of(const std::string& path) const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(BodiesTest, ANewSceneIsEmptyAndAsksBeforeItLosesEdits) {
  choose_material("concrete");
  press_key('N', true);
  EXPECT_TRUE(editor_.state().unsaved) << "edits that are not saved";
  EXPECT_EQ(bodies(), 1u);
  editor_.state().unsaved.reset();
  begin();
  EXPECT_EQ(bodies(), 0u);
  editor_.run().step();
  EXPECT_EQ(editor_.run().frame().step, 1) << "nothing is simulated, too";
}

TEST_F(BodiesTest, BodiesAreAddedBesideEachOtherOnTheGround) {
  begin();
  double right = -1e9;
  for (const std::string_view name : kAdded) {
    const std::size_t first = editor_.run().frame().nodes.positions.size();
    add(name);
    const auto positions = editor_.run().frame().nodes.positions.subspan(first);
    ASSERT_GT(positions.size(), 0u) << name;
    double low = 1e9, left = 1e9, end = -1e9;
    for (const Vec3& position : positions) {
      low = std::min(low, position.y());
      left = std::min(left, position.x());
      end = std::max(end, position.x());
    }
    EXPECT_NEAR(low, 0, 1e-6) << name << " stands on the ground";
    EXPECT_GT(left, right) << name << " touches none";
    right = end;
  }
  EXPECT_EQ(bodies(), 6u);
  for (int i = 0; i < 15; ++i) editor_.run().step();
  EXPECT_EQ(editor_.run().frame().crack_events.size(), 0u) << "what stands there stays whole";
  EXPECT_EQ(editor_.run().frame().bodies.size(), 6u);
}

TEST_F(BodiesTest, WhatIsAddedOutOfViewIsBroughtIntoIt) {
  const ui::Command array = {.name = "edit.make_array", .step = 5, .offset = Vec3(0, 0, 20)};
  for (const ui::Command& command : {ui::Command{.name = "add.box"}, ui::Command{.name = "add.table"},
                                     ui::Command{.name = "edit.duplicate"}, array}) {
    editor_.viewport().look_from(Vec3(0, 1, 40), Vec3(0, 1, 100));
    draw();
    EXPECT_EQ(hits_across(), 0);
    editor_.execute(command);
    settle();
    EXPECT_GT(hits_across(), 0) << command.name;
  }
}

TEST_F(BodiesTest, TheViewStaysWhereWhatIsAddedIsInIt) {
  editor_.viewport().look_from(Vec3(0, 3, 40), Vec3(0, 1, 0));
  for (const char* command : {"add.box", "add.table", "edit.duplicate"}) {
    add(command);
    EXPECT_EQ(editor_.viewport().camera().position, Eigen::Vector3f(0, 3, 40)) << command;
    EXPECT_EQ(editor_.viewport().camera().target, Eigen::Vector3f(0, 1, 0)) << command;
  }
}

TEST_F(BodiesTest, ACopyHasANameOfItsOwnAndDeletingTakesItOut) {
  begin();
  add("add.box");
  press_key('D', true);
  settle();
  EXPECT_EQ(bodies(), 2u);
  EXPECT_EQ(value("bodies/1"), "box 2");
  press_key(ui::key::kDelete);
  settle();
  EXPECT_EQ(bodies(), 1u);
  press_key('Z', true);
  settle();
  EXPECT_EQ(bodies(), 2u) << "undone";
  press_key(ui::key::kDelete);
  press_key(ui::key::kDelete);
  settle();
  EXPECT_EQ(bodies(), 0u);
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "bodies/0"));
}

TEST_F(BodiesTest, ASceneMadeFromNothingIsSavedAndReadToTheSameBytes) {
  std::filesystem::create_directories(test_folder());
  begin();
  for (const std::string_view name : kAdded) add(name);
  editor_.execute({.name = "file.save", .path = file("a.json"), .replace = true});
  ASSERT_TRUE(check_scene(file("a.json")).empty());
  editor_.builder().open(file("a.json"));
  settle();
  ASSERT_EQ(bodies(), 6u);
  editor_.execute({.name = "file.save", .path = file("b.json"), .replace = true});
  EXPECT_EQ(text_of(file("a.json")), text_of(file("b.json")));
  // Back and forth through the history changes nothing either.
  for (int i = 0; i < 3; ++i) editor_.execute({.name = "edit.duplicate"});
  settle();
  for (int i = 0; i < 3; ++i) editor_.execute({.name = "edit.undo"});
  settle();
  editor_.execute({.name = "file.save", .path = file("b.json"), .replace = true});
  EXPECT_EQ(text_of(file("a.json")), text_of(file("b.json")));
  std::filesystem::remove_all(test_folder());
}

TEST_F(BodiesTest, AShotCanBecomePartOfTheSceneAndHitsAgain) {
  editor_.run().step();
  editor_.run().step();
  const std::size_t shots = editor_.run().frame().projectiles.size();
  click("projectile/preset");
  click("projectile/preset/steel ball");
  EXPECT_EQ(editor_.state().shot.mass, 0.263);
  editor_.execute({.name = "simulation.fire"});
  editor_.run().step();
  ASSERT_EQ(editor_.run().frame().projectiles.size(), shots + 1);
  const Vec3 place = editor_.run().frame().projectiles.back().position;
  draw();
  click("projectile/keep");
  settle();
  EXPECT_EQ(editor_.run().frame().step, 0) << "the scene starts again";
  for (int i = 0; i < 3; ++i) editor_.run().step();
  ASSERT_EQ(editor_.run().frame().projectiles.size(), shots + 1);
  double nearest = 1e9;
  for (const ProjectileView& projectile : editor_.run().frame().projectiles)
    nearest = std::min(nearest, (projectile.position - place).norm());
  EXPECT_LT(nearest, 1e-6) << "as it flew before";
}

TEST_F(BodiesTest, SupportsLoadsProbesAndShotsAreAddedDuplicatedAndDeleted) {
  begin();
  add("add.box");
  const std::string before = scene_to_json(editor_.document().scene());
  for (const std::string_view name : {"add.support", "add.load", "add.probe", "add.projectile"}) {
    add(name);
    EXPECT_FALSE(editor_.state().error) << name;
  }
  const auto held = std::ranges::count(editor_.run().frame().nodes.has_support, 1);
  EXPECT_EQ(held, 25) << "all nodes of the lower face, and no others";
  EXPECT_EQ(editor_.run().frame().probes.size(), 1u);
  EXPECT_FALSE(editor_.run().frame().nodes.load_forces.empty());
  click("probes/0");
  press_key('D', true);
  settle();
  EXPECT_EQ(editor_.run().frame().probes.size(), 2u);
  for (const char* tag : {"projectiles/0", "probes/0", "bodies/0/loads/0", "bodies/0/supports/0"}) {
    click(tag);
    press_key(ui::key::kDelete);
    press_key(ui::key::kDelete);  // the next of the kind, and never another kind
    settle();
  }
  EXPECT_EQ(scene_to_json(editor_.document().scene()), before);
  EXPECT_EQ(bodies(), 1u);
}

TEST_F(BodiesTest, AHiddenBodyIsNotDrawnButSimulated) {
  begin();
  add("add.box");
  add("add.sphere");
  editor_.execute({.name = "view.frame_all"});
  draw(2);
  const int both = hits_across();
  click("bodies/1/eye");
  const int one = hits_across();
  EXPECT_LT(one, both);
  EXPECT_GT(one, 0);
  click("bodies/0/eye");
  EXPECT_EQ(hits_across(), 0);
  EXPECT_EQ(bodies(), 2u);
  const double height = editor_.run().frame().bodies[1].center_of_mass.y();
  for (int i = 0; i < 5; ++i) editor_.run().step();
  EXPECT_NE(editor_.run().frame().bodies[1].center_of_mass.y(), height);
  click("bodies/0/eye");
  click("bodies/1/eye");
  EXPECT_EQ(hits_across(), both);
}

/// Blocks whose world takes longer to build than the window waits for it.
Scene large_blocks() {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    BodyDescription block;
    block.name = "block " + std::to_string(i + 1);
    block.shape = BoxShape{Vec3::Constant(1), Vec3::Constant(1.0 / 24)};
    block.position = Vec3(1.5 * i, 0.5, 0);
    block.supports = {{HalfSpaceRegion{Vec3(0, -0.5, 0), -Vec3::UnitY()}}};  // whose static start is to be found
    scene.bodies.push_back(block);
  }
  return scene;
}

TEST_F(BodiesTest, WhatKeysAskForWhileTheWorldIsBuiltIsDoneAfterIt) {
  std::filesystem::create_directories(test_folder());
  write_scene(large_blocks(), file("blocks.json"));
  editor_.builder().open(file("blocks.json"));
  settle();
  ASSERT_EQ(bodies(), 3u);
  click("bodies/0");
  ui::press(queue_, {ui::key::kDelete});
  ui::press(queue_, {ui::key::kDelete});
  while (!queue_.empty()) {
    queue_.play(ImGui::GetIO());
    draw();
  }
  ASSERT_NE(editor_.state().work, "") << "it takes long";
  EXPECT_EQ(value("work/waiting"), "Then: Delete");
  settle();
  EXPECT_EQ(editor_.document().scene().bodies.size(), 1u) << "no press is lost";
  EXPECT_EQ(bodies(), 1u);
  EXPECT_EQ(value("bodies/0"), "block 3");
}

TEST_F(BodiesTest, WhatWaitedForWorkThatIsCancelledIsReportedAndNotDone) {
  std::filesystem::create_directories(test_folder());
  write_scene(large_blocks(), file("blocks.json"));
  editor_.builder().open(file("blocks.json"));
  settle();
  click("bodies/0");
  press_key('D', true);
  ASSERT_NE(editor_.state().work, "") << "it takes long";
  press_key(ui::key::kDelete);
  draw(2);
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().waiting.empty());
  EXPECT_EQ(editor_.document().scene().bodies.size(), 3u) << "the copy was taken back, and nothing else is gone";
  EXPECT_THAT(editor_.state().log.back().text, ::testing::HasSubstr("Delete was skipped"));
}

TEST_F(BodiesTest, EntriesAreReorderedAndUndoneToTheSameBytes) {
  begin();
  add("add.box");
  add("add.plate");
  const std::string before = scene_to_json(editor_.document().scene());
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  click("bodies/1");
  press_key(ui::key::kUp, true);
  settle();
  EXPECT_EQ(value("bodies/0"), "plate");
  EXPECT_EQ(editor_.run().frame().materials[0].young_modulus,
            editor_.document().scene().bodies[0].material.young_modulus);
  const std::string after = scene_to_json(editor_.document().scene());
  EXPECT_NE(after, before);
  press_key('Z', true);
  settle();
  EXPECT_EQ(scene_to_json(editor_.document().scene()), before);
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
  press_key('Z', true, true);
  settle();
  EXPECT_EQ(scene_to_json(editor_.document().scene()), after);
  EXPECT_FALSE(editor_.state().error);
}

}  // namespace
}  // namespace griffith::app
