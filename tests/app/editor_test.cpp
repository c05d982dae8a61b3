#include "app/editor/editor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>

#include "editor_fixture.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

TEST_F(EditorTest, MaterialsActOnTheRunningSimulation) {
  editor_.run().step();
  click("material/yields");
  EXPECT_EQ(editor_.run().frame().step, 1);
  EXPECT_TRUE(editor_.run().frame().materials[0].yield_strength);
}

TEST_F(EditorTest, PausedPictureShowsAnEditedMaterial) {
  editor_.state().view.quantity = "material";
  const ui::WidgetTag* view = ui::find_tag(editor_.tags(), "viewport");
  const ImVec2 middle = view->center();
  const auto brightness = [&] {
    draw(2);
    const render::Image image = window_image();
    const auto pixel = image.pixel(static_cast<int>(middle.x), static_cast<int>(middle.y));
    return pixel[0] + pixel[1] + pixel[2];
  };
  const int before = brightness();
  click("material/preset");
  click("material/preset/rubber");
  EXPECT_LT(brightness(), before / 2);
}

TEST_F(EditorTest, LettersTypedRightAfterTheShortcutOfThePaletteAreItsText) {
  ui::press(queue_, {'P', true});
  for (const char letter : std::string("go")) {  // alone, they are shortcuts
    const int key = letter - 'a' + 'A';
    queue_.key(key, true);
    queue_.text(static_cast<unsigned char>(letter));
    queue_.key(key, false);
  }
  play();
  draw(3);
  EXPECT_EQ(value("palette/text"), "go");
  EXPECT_EQ(editor_.state().gizmo, ui::GizmoTool::none);
}

TEST_F(EditorTest, StepAndResetMoveTheClock) {
  EXPECT_EQ(value("toolbar/step"), "step 0");
  click("command/simulation.step");
  click("command/simulation.step");
  EXPECT_EQ(value("toolbar/step"), "step 2");
  click("command/simulation.reset");
  EXPECT_EQ(value("toolbar/step"), "step 0");
}

TEST_F(EditorTest, RunsInSlowMotionOnlyWhileRunning) {
  editor_.run().advance(1);
  draw();
  EXPECT_EQ(value("toolbar/step"), "step 0");
  click("command/simulation.run");
  editor_.state().speed = 0.1;
  for (int i = 0; i < 50; ++i) editor_.run().advance(0.02);  // a second: a tenth of the 120 steps
  draw();
  EXPECT_EQ(value("toolbar/step"), "step 12");
}

TEST_F(EditorTest, LayersAndElementsAreChosenInTheViewPanel) {
  click("view/layers");
  click("view/layers/stress_axes");
  EXPECT_EQ(editor_.state().view.layers, std::vector{ViewLayer::stress_axes});
  EXPECT_LT(editor_.state().view.opacity, 1);
  click("view/layers/stress_axes");
  EXPECT_TRUE(editor_.state().view.layers.empty());
  click("view/layers/fracture_planes");
  click("viewport");  // closes the list
  EXPECT_EQ(value("view/fracture_planes"), "100");
  click("view/element_rows");
  click("view/elements");
  click("view/elements/shrunken");
  EXPECT_EQ(editor_.state().view.elements, ElementStyle::shrunken);
  click("view/slice");
  ASSERT_TRUE(editor_.state().view.slice);
  click("view/slice_Y");
  EXPECT_EQ(editor_.state().view.slice->normal, Vec3::UnitY());
  EXPECT_NEAR(editor_.state().view.slice->offset, 1, 1e-4);  // the middle of the wall
  click("view/slice_flip");
  EXPECT_EQ(editor_.state().view.slice->normal, -Vec3::UnitY());
}

TEST_F(EditorTest, RightClickInTheViewHitsTheWallThere) {
  Scene still = small_wall();
  still.projectiles.clear();
  const std::filesystem::path path = test_folder() / "still.json";
  write_scene(still, path);
  editor_.builder().open(path);
  draw(2);
  const auto step_until_contact = [this] {
    int steps = 0;
    do {
      click("command/simulation.step");
    } while (value("value/Contacts") == "0" && ++steps < 40);
    return value("value/Contacts") != "0";
  };
  ASSERT_FALSE(step_until_contact());
  click("viewport", 1);
  EXPECT_TRUE(step_until_contact());
}

TEST_F(EditorTest, BadFileIsShownAndEverythingStays) {
  click("command/simulation.step");
  editor_.builder().open("no_such_scene.json");
  draw(2);
  ASSERT_TRUE(editor_.state().error.has_value());
  EXPECT_EQ(value("toolbar/step"), "step 1");
  click("error/close");
  EXPECT_FALSE(editor_.state().error.has_value());
  editor_.builder().open(small_wall_file());
  draw();
  EXPECT_FALSE(editor_.state().error.has_value());
  EXPECT_EQ(value("toolbar/step"), "step 0");
}

TEST_F(EditorTest, EditsThatAreNotSavedAreNotLostUnasked) {
  click("material/preset");
  click("material/preset/concrete");
  const ui::Command open{.name = "file.open_path", .path = small_wall_file()}, quit{.name = "file.quit"};
  editor_.execute(open);
  draw(4);
  click("unsaved/cancel");
  EXPECT_FALSE(editor_.state().unsaved);
  EXPECT_NE(editor_.document().title().find('*'), std::string::npos) << "all is as it was";

  editor_.execute(quit);
  draw(4);
  EXPECT_FALSE(editor_.requests().quit);
  click("unsaved/discard");
  EXPECT_TRUE(editor_.requests().quit);
}

TEST_F(EditorTest, EditsCanBeSavedBeforeAnotherSceneOpens) {
  const std::filesystem::path saved = test_folder() / "edited.json";
  std::filesystem::remove(saved);  // of an earlier run: it would not be replaced unasked
  editor_.execute({.name = "file.save", .path = saved});
  click("material/preset");
  click("material/preset/concrete");
  editor_.execute({.name = "file.open_path", .path = small_wall_file()});
  draw(4);
  click("unsaved/save");
  wait_for_work();
  EXPECT_EQ(read_scene(saved).bodies[0].material.name, "concrete");
  EXPECT_EQ(editor_.document().title().find('*'), std::string::npos);
  EXPECT_FALSE(editor_.state().unsaved);
}

TEST_F(EditorTest, RangeLockKeepsWhatIsShown) {
  for (int i = 0; i < 3; ++i) click("command/simulation.step");
  click("view/lock_range");
  ASSERT_TRUE(editor_.state().view.range.has_value());
  const Vec2 range = *editor_.state().view.range;
  EXPECT_LT(range[0], range[1]);
  click("command/simulation.step");
  EXPECT_EQ(*editor_.state().view.range, range);
  click("view/lock_range");
  EXPECT_FALSE(editor_.state().view.range.has_value());
}

TEST_F(EditorTest, AutomaticRangeIsThatOfAPictureOfTheStepAlone) {
  World world(small_wall());
  SteadyRange headless;
  headless.follow(world.frame(), "von_mises");
  for (int step = 1; step <= 24; ++step) {
    editor_.run().step();
    if (step % 5 == 0) draw();  // not of every step
    world.step();
    headless.follow(world.frame(), "von_mises");
  }
  draw(2);
  editor_.execute({.name = "view.lock_range"});
  EXPECT_TRUE(editor_.state().view.range->cast<float>() == headless.range()->cast<float>());
}

TEST_F(EditorTest, AutomaticRangeStartsAgainWithAnotherMaterial) {
  for (int step = 0; step < 24; ++step) editor_.run().step();
  choose_material("concrete");
  SteadyRange alone;
  alone.follow(editor_.run().frame(), "von_mises");
  editor_.execute({.name = "view.lock_range"});
  EXPECT_TRUE(editor_.state().view.range->cast<float>() == alone.range()->cast<float>());
}

TEST_F(EditorTest, HomeLeavesOutWhatFliesFar) {
  Scene scene = small_wall();
  scene.projectiles[0].position = Vec3(3, 2, 0);
  scene.projectiles[0].direction = Vec3(1, 1, 0);
  scene.projectiles[0].speed = 100;
  const auto path = test_folder() / "past.json";
  write_scene(scene, path);
  editor_.builder().open(path);
  for (int step = 0; step < 60; ++step) editor_.run().step();
  draw(2);
  editor_.execute({.name = "view.frame_all"});
  draw(2);
  editor_.execute({.name = "view.pick", .cursor = Vec2(0.5, 0.5)});
  EXPECT_TRUE(editor_.state().selection.valid());  // the wall is in the middle of the view
}

TEST_F(EditorTest, HomeFillsANarrowPicture) {
  editor_.execute({.name = "view.frame_all"});
  draw(2);
  EXPECT_GT(hits_across(), 50);
  EXPECT_LT(hits_across(), 100);
}

/// An editor that starts with a scene without cameras.
class EditorWithoutCameras : public EditorTest {
 protected:
  EditorWithoutCameras() : EditorTest(scene()) {}

  static Scene scene() {
    Scene scene = small_wall();
    scene.cameras.clear();
    scene.projectiles.clear();
    return scene;
  }
};

TEST_F(EditorWithoutCameras, TheFirstPictureIsFramedAsHomeFramesIt) {
  draw();
  const int first = hits_across();
  editor_.execute({.name = "view.frame_all"});
  draw(2);
  EXPECT_EQ(first, hits_across());
  write_scene(scene(), test_folder() / "opened.json");
  editor_.builder().open(test_folder() / "opened.json");
  draw(2);
  EXPECT_EQ(first, hits_across());
}

TEST_F(EditorTest, SavedSceneOpensAsItWasEditedAndShown) {
  const std::filesystem::path path = small_wall_file();
  editor_.builder().open(path);
  wait_for_work();
  click("view/edges");
  click("material/preset");
  click("material/preset/concrete");
  EXPECT_EQ(editor_.document().title().find('*'), std::string("small wall ").size());
  ImGui::GetIO().KeyCtrl = true;
  ImGui::GetIO().KeysDown['S'] = true;
  draw();
  ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeysDown['S'] = false;
  draw();
  const Scene saved = read_scene(path);
  EXPECT_EQ(saved.bodies[0].material.name, "concrete");
  EXPECT_FALSE(saved.view.edges);
  EXPECT_EQ(editor_.document().title(), "small wall - Griffith");
}

TEST_F(EditorTest, AScreenshotIsRequestedWithoutQuitting) {
  EXPECT_FALSE(editor_.requests().screenshot);
  click("command/file.screenshot");
  EXPECT_TRUE(editor_.requests().screenshot);
  EXPECT_FALSE(editor_.requests().quit);
}

}  // namespace
}  // namespace griffith::app
