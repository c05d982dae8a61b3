#include "app/editor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "editor_fixture.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "sim/world/node_report.h"
#include "ui/units.h"

namespace griffith::app {
namespace {

TEST_F(EditorTest, WorkThatLastsShowsADialogThatCancelsIt) {
  Scene scene = small_wall();
  test_file("ball.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  SurfaceShape shape;
  shape.path = test_folder() / "ball.off";
  shape.meshing.method = MeshingMethod::volumetric;
  shape.meshing.element_size = 0.01;  // two million lattice vertices
  scene.bodies[0].shape = shape;
  scene.bodies[0].supports.clear();
  const auto path = test_folder() / "ball.json";
  write_scene(scene, path);
  const std::string before = editor_.title();
  editor_.open(path);
  insist();
  const auto begins = [&] { return value("work/stage") == "Building the bodies" || value("work/stage") == "Meshing body 1 of 1"; };
  for (int i = 0; i < 600 && begins(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    draw();
  }
  EXPECT_THAT(value("work/stage"),
              ::testing::AnyOf("Filling with tetrahedra", "Finding the inside", "Finding the border"));
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_EQ(editor_.title(), before);
  EXPECT_FALSE(editor_.state().error);
}

TEST_F(EditorTest, AMeshThatWouldBeHugeAsksFirst) {
  const std::size_t tets = editor_.frame().tets.size();
  const std::string before = editor_.title();
  Scene scene = small_wall();
  BoxShape box;
  box.element_size = Vec3::Constant(0.011);
  scene.bodies[0].shape = box;
  write_scene(scene, test_folder() / "fine.json");
  editor_.open(test_folder() / "fine.json");
  wait_for_work();
  EXPECT_THAT(value("large_mesh/text"), ::testing::HasSubstr("about 3,800,000 tetrahedra"));
  click("large_mesh/cancel");
  EXPECT_EQ(editor_.title(), before);
  EXPECT_EQ(editor_.frame().tets.size(), tets);
  EXPECT_FALSE(editor_.state().large_mesh);
}

TEST_F(EditorTest, AnEditThatWouldMakeAHugeMeshCanBeTakenBack) {
  const std::size_t tets = editor_.frame().tets.size();
  click("body");
  click("body/shape");
  click("body/shape/kind_of");
  click("body/shape/kind_of/sphere");
  wait_for_work();
  const std::size_t of_sphere = editor_.frame().tets.size();
  EXPECT_NE(of_sphere, tets);
  click("body/shape/sphere/element_size", 1);
  for (const char letter : std::string("9 mm")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
  draw();
  EXPECT_EQ(value("typed_meaning"), "= 9 mm");
  click("view/shading");
  wait_for_work();
  EXPECT_NE(value("large_mesh/text"), "no widget large_mesh/text");
  click("large_mesh/cancel");
  EXPECT_EQ(editor_.frame().tets.size(), of_sphere);
  EXPECT_EQ(value("body/shape/sphere/element_size"), "200 mm");
}

TEST_F(EditorTest, AnEditedShapeStartsTheSimulationAgainAndTheEditCanBeUndone) {
  const std::size_t tets = editor_.frame().tets.size();
  editor_.step();
  EXPECT_EQ(editor_.frame().step, 1);
  click("body");
  click("body/remeshing");
  wait_for_work();
  EXPECT_EQ(editor_.frame().step, 0);
  click("body/shape");
  click("body/shape/kind_of");
  click("body/shape/kind_of/sphere");
  wait_for_work();
  EXPECT_NE(editor_.frame().tets.size(), tets);
  click("command/edit.undo");
  wait_for_work();
  EXPECT_EQ(editor_.frame().tets.size(), tets);
  EXPECT_FALSE(editor_.state().error);
}

TEST_F(EditorTest, MaterialsActOnTheRunningSimulation) {
  editor_.step();
  click("material/yields");
  EXPECT_EQ(editor_.frame().step, 1);
  EXPECT_TRUE(editor_.frame().materials[0].yield_strength);
}

TEST_F(EditorTest, PausedPictureShowsAnEditedMaterial) {
  editor_.state().view.quantity = "material";
  const ui::WidgetTag* view = ui::find_tag(editor_.tags(), "viewport");
  const ImVec2 middle = view->center();
  const auto brightness = [&] {
    draw(2);
    const render::Image image = target_.image();
    const auto pixel = image.pixel(static_cast<int>(middle.x), static_cast<int>(middle.y));
    return pixel[0] + pixel[1] + pixel[2];
  };
  const int before = brightness();
  click("material/preset");
  click("material/preset/rubber");
  EXPECT_LT(brightness(), before / 2);
}

constexpr char kTetSurface[] = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST_F(EditorTest, ABodyIsFilledFromASurfaceAndTheEditCanBeUndone) {
  const std::string file = test_file("ball.off", kTetSurface).string();
  click("menu/File");
  click("menu/file.add_surface");
  draw(4);
  ui::SurfaceRequest& request = editor_.state().surface;
  std::copy(file.begin(), file.end(), request.path.begin());
  request.method = MeshingMethod::volumetric;
  request.automatic_size = false;
  request.element_size = 0.2;
  draw(4);
  click("surface/fill");
  wait_for_work();
  EXPECT_EQ(value("report/title"), "Added the body \"ball\"");
  EXPECT_THAT(value("report/fact0"), ::testing::HasSubstr("tetrahedra"));
  click("report/close");
  EXPECT_EQ(value("bodies/1"), "ball");
  EXPECT_EQ(editor_.state().selected_body, 1);
  click("command/simulation.step");
  EXPECT_EQ(value("toolbar/step"), "step 1");
  click("menu/Edit");
  click("menu/edit.undo");
  EXPECT_EQ(value("bodies/1"), "no widget bodies/1");
  EXPECT_EQ(editor_.state().selected_body, 0);
  click("menu/Edit");
  click("menu/edit.redo");
  EXPECT_EQ(value("bodies/1"), "ball");
  click("command/simulation.step");
  EXPECT_FALSE(editor_.state().error);
}

TEST_F(EditorTest, ASurfaceThatCannotBeFilledChangesNothing) {
  const std::string file = test_file("sheet.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 2 1\n").string();
  std::copy(file.begin(), file.end(), editor_.state().surface.path.begin());
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  wait_for_work();
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->problem, ::testing::HasSubstr("no inside"));
  EXPECT_EQ(value("bodies/1"), "no widget bodies/1");
}

TEST_F(EditorTest, FillingASurfaceCanBeCancelled) {
  const std::string file = test_file("ball.off", kTetSurface).string();
  ui::SurfaceRequest& request = editor_.state().surface;
  std::copy(file.begin(), file.end(), request.path.begin());
  request.method = MeshingMethod::volumetric;
  request.automatic_size = false;
  request.element_size = 0.01;  // two million lattice vertices
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  insist();
  EXPECT_NE(value("work/stage"), "no widget work/stage");
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_EQ(value("bodies/1"), "no widget bodies/1");
  EXPECT_FALSE(editor_.state().error);
}

/// A tetrahedron whose legs are this long [m].
std::string tet_surface(const std::string& leg) {
  return "OFF\n4 4 0\n0 0 0\n" + leg + " 0 0\n0 " + leg + " 0\n0 0 " + leg + "\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

TEST_F(EditorTest, ABrokenFileOpenedDuringWorkLeavesTheWorkAndTheEdits) {
  const std::string file = test_file("ball.off", tet_surface("1")).string();
  click("material/yields");
  ui::SurfaceRequest& request = editor_.state().surface;
  std::copy(file.begin(), file.end(), request.path.begin());
  request.method = MeshingMethod::volumetric;
  request.automatic_size = false;
  request.element_size = 0.05;
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  editor_.open(test_file("broken.json", "{\"bodies\": ["));
  wait_for_work();
  ASSERT_TRUE(editor_.state().error);
  click("error/close");
  draw(4);
  click("report/close");
  EXPECT_EQ(value("bodies/1"), "ball");
  EXPECT_NE(editor_.title().find('*'), std::string::npos) << "nothing was saved";
  click("command/edit.undo");
  EXPECT_EQ(value("bodies/1"), "no widget bodies/1");
  click("command/edit.undo");
  EXPECT_EQ(editor_.title().find('*'), std::string::npos);
}

TEST_F(EditorTest, UndoThatTakesLongCanBeCancelledAndLeavesWhatWas) {
  Scene scene = small_wall();
  SurfaceShape shape;
  shape.path = test_file("grown.off", tet_surface("0.1"));
  shape.meshing.method = MeshingMethod::volumetric;
  shape.meshing.element_size = 0.012;
  scene.bodies[0].supports.clear();
  scene.bodies[0].shape = shape;
  const auto path = test_folder() / "grown.json";
  write_scene(scene, path);
  editor_.open(path);
  draw();
  wait_for_work();
  ASSERT_FALSE(editor_.state().error) << editor_.state().error->where << ": " << editor_.state().error->problem;
  const std::string file = test_file("ball.off", kTetSurface).string();
  ui::SurfaceRequest& request = editor_.state().surface;
  std::copy(file.begin(), file.end(), request.path.begin());
  request.method = MeshingMethod::volumetric;
  request.automatic_size = false;
  request.element_size = 0.2;
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  wait_for_work();
  ASSERT_FALSE(editor_.state().error) << editor_.state().error->where << ": " << editor_.state().error->problem;
  click("report/close");
  ASSERT_EQ(value("bodies/1"), "ball");
  const std::size_t tets = editor_.frame().tets.size();
  test_file("grown.off", tet_surface("1.2"));  // 1,728 times the elements
  click("command/edit.undo");
  insist();
  ASSERT_NE(value("work/stage"), "no widget work/stage");
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_EQ(value("bodies/1"), "ball");
  EXPECT_EQ(editor_.frame().tets.size(), tets);
  EXPECT_FALSE(editor_.state().error);
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
  editor_.advance(1);
  draw();
  EXPECT_EQ(value("toolbar/step"), "step 0");
  click("command/simulation.run");
  editor_.state().speed = 0.1;
  for (int i = 0; i < 50; ++i) editor_.advance(0.02);  // a second: a tenth of the 120 steps
  draw();
  EXPECT_EQ(value("toolbar/step"), "step 12");
}

TEST_F(EditorTest, ClickInTheViewSelectsAnElementOfTheWall) {
  click("viewport");
  EXPECT_TRUE(editor_.state().selection.valid());
  EXPECT_EQ(value("value/Element"), std::to_string(editor_.state().selection.tet.value));
}

TEST_F(EditorTest, SelectionIsExplainedAndSurvivesBreakingAndReset) {
  click("viewport");
  const ui::Selection selected = editor_.state().selection;
  ASSERT_TRUE(selected.valid());
  EXPECT_EQ(value("value/Node"), std::to_string(selected.node.value));
  for (int i = 0; i < 12; ++i) click("command/simulation.step");
  EXPECT_EQ(editor_.state().selection.rest_position, selected.rest_position);
  EXPECT_NE(value("inspector/verdict").find("resistance"), std::string::npos);
  EXPECT_GE(std::stoi(value("inspector/margin_plot")), 13);
  const NodeReport report = node_report(editor_.frame(), editor_.state().selection.node);
  EXPECT_EQ(value("inspector/element/0"),
            ui::format_quantity(report.elements.front().share, report.by_tension ? "Pa" : "N", 3));
  click("command/simulation.reset");
  EXPECT_EQ(editor_.state().selection, selected);
}

TEST_F(EditorTest, KeysSliceTheBodiesAndSelectTheMostLoadedNode) {
  const auto press = [this](int key) {
    ImGui::GetIO().KeysDown[key] = true;
    draw();
    ImGui::GetIO().KeysDown[key] = false;
    draw();
  };
  for (int i = 0; i < 6; ++i) click("command/simulation.step");
  press('M');
  ASSERT_TRUE(editor_.state().selection.valid());
  const auto& separations = editor_.frame().separations;
  for (const NodeSeparation& separation : separations)
    EXPECT_LE(separation.margin, separations[static_cast<std::size_t>(editor_.state().selection.node)].margin);
  press('X');
  ASSERT_TRUE(editor_.state().view.slice);
  const double offset = editor_.state().view.slice->offset;
  editor_.state().camera_motion.slice_up = 0.1f;
  draw();
  EXPECT_NE(editor_.state().view.slice->offset, offset);
  press('X');
  EXPECT_FALSE(editor_.state().view.slice);
}

TEST_F(EditorTest, TheInspectorShowsWhatAddsUpAndTheMaterialOfWhatItExplains) {
  Scene scene = small_wall();
  BodyDescription other = scene.bodies[0];
  other.name = "other";
  other.position.x() = 4;
  scene.bodies.insert(scene.bodies.begin(), other);
  const auto path = test_folder() / "two.json";
  write_scene(scene, path);
  editor_.open(path);
  wait_for_work();
  for (int i = 0; i < 6; ++i) editor_.step();
  editor_.state().selected_body = 0;
  press_key('M');
  const NodeId node = editor_.state().selection.node;
  ASSERT_TRUE(node.valid());
  const NodeReport report = node_report(editor_.frame(), node);
  EXPECT_EQ(editor_.state().selected_body, editor_.frame().bodies[report.body].scene_body);
  EXPECT_EQ(editor_.state().selected_body, 1) << "it is the one that was struck";
  EXPECT_EQ(value("value/Together"), ui::format_quantity(report.sum(), report.by_tension ? "Pa" : "N", 3));
  EXPECT_EQ(value("value/Load now"), ui::format_quantity(report.load, "Pa"));
}

TEST_F(EditorTest, TheKeyForTheMostLoadedNodeSaysWhyThereIsNone) {
  Scene scene = small_wall();
  scene.projectiles.clear();
  scene.bodies[0].supports.clear();
  scene.bodies[0].material.tensile_strength = 1e9;
  const auto path = test_folder() / "lying.json";
  write_scene(scene, path);
  editor_.open(path);
  wait_for_work();
  for (int i = 0; i < 60; ++i) editor_.step();
  press_key('M');
  EXPECT_FALSE(editor_.state().selection.valid());
  EXPECT_THAT(value("status/message"), ::testing::HasSubstr("rigid"));
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
  editor_.open(path);
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
  editor_.open("no_such_scene.json");
  draw(2);
  ASSERT_TRUE(editor_.state().error.has_value());
  EXPECT_EQ(value("toolbar/step"), "step 1");
  click("error/close");
  EXPECT_FALSE(editor_.state().error.has_value());
  editor_.open(small_wall_file());
  draw();
  EXPECT_FALSE(editor_.state().error.has_value());
  EXPECT_EQ(value("toolbar/step"), "step 0");
}

TEST_F(EditorTest, EditsThatAreNotSavedAreNotLostUnasked) {
  click("material/preset");
  click("material/preset/concrete");
  const ui::Command open{.id = ui::CommandId::open, .path = small_wall_file()}, quit{.id = ui::CommandId::quit};
  editor_.execute(open);
  draw(4);
  click("unsaved/cancel");
  EXPECT_FALSE(editor_.state().unsaved);
  EXPECT_NE(editor_.title().find('*'), std::string::npos) << "all is as it was";

  editor_.execute(quit);
  draw(4);
  EXPECT_FALSE(editor_.wants_to_quit());
  click("unsaved/discard");
  EXPECT_TRUE(editor_.wants_to_quit());
}

TEST_F(EditorTest, EditsCanBeSavedBeforeAnotherSceneOpens) {
  const std::filesystem::path saved = test_folder() / "edited.json";
  std::filesystem::remove(saved);  // of an earlier run: it would not be replaced unasked
  editor_.execute({.id = ui::CommandId::save, .path = saved});
  click("material/preset");
  click("material/preset/concrete");
  editor_.execute({.id = ui::CommandId::open, .path = small_wall_file()});
  draw(4);
  click("unsaved/save");
  wait_for_work();
  EXPECT_EQ(read_scene(saved).bodies[0].material.name, "concrete");
  EXPECT_EQ(editor_.title().find('*'), std::string::npos);
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
    editor_.step();
    if (step % 5 == 0) draw();  // not of every step
    world.step();
    headless.follow(world.frame(), "von_mises");
  }
  draw(2);
  editor_.execute({.id = ui::CommandId::toggle_range_lock});
  EXPECT_TRUE(editor_.state().view.range->cast<float>() == headless.range()->cast<float>());
}

TEST_F(EditorTest, AutomaticRangeStartsAnewWithAnotherMaterial) {
  for (int step = 0; step < 24; ++step) editor_.step();
  choose_material("concrete");
  SteadyRange alone;
  alone.follow(editor_.frame(), "von_mises");
  editor_.execute({.id = ui::CommandId::toggle_range_lock});
  EXPECT_TRUE(editor_.state().view.range->cast<float>() == alone.range()->cast<float>());
}

TEST_F(EditorTest, HomeLeavesOutWhatFliesFar) {
  Scene scene = small_wall();
  scene.projectiles[0].position = Vec3(3, 2, 0);
  scene.projectiles[0].direction = Vec3(1, 1, 0);
  scene.projectiles[0].speed = 100;
  const auto path = test_folder() / "past.json";
  write_scene(scene, path);
  editor_.open(path);
  for (int step = 0; step < 60; ++step) editor_.step();
  draw(2);
  editor_.execute({.id = ui::CommandId::frame_all});
  draw(2);
  editor_.execute({.id = ui::CommandId::pick, .cursor = Vec2(0.5, 0.5)});
  EXPECT_TRUE(editor_.state().selection.valid());  // the wall is in the middle of the view
}

TEST_F(EditorTest, HomeFillsANarrowPicture) {
  editor_.execute({.id = ui::CommandId::frame_all});
  draw(2);
  int hits = 0;
  for (int i = 0; i < 100; ++i) {
    editor_.execute({.id = ui::CommandId::pick, .cursor = Vec2((i + 0.5) / 100, 0.5)});
    hits += editor_.state().selection.valid();
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(hits, 100);
}

TEST_F(EditorTest, SavedSceneOpensAsItWasEditedAndShown) {
  const std::filesystem::path path = small_wall_file();
  editor_.open(path);
  draw(2);
  click("view/edges");
  click("material/preset");
  click("material/preset/concrete");
  EXPECT_EQ(editor_.title().find('*'), std::string("small wall ").size());
  ImGui::GetIO().KeyCtrl = true;
  ImGui::GetIO().KeysDown['S'] = true;
  draw();
  ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeysDown['S'] = false;
  draw();
  const Scene saved = read_scene(path);
  EXPECT_EQ(saved.bodies[0].material.name, "concrete");
  EXPECT_FALSE(saved.view.edges);
  EXPECT_EQ(editor_.title(), "small wall - Griffith");
}

TEST_F(EditorTest, ScreenshotAndQuitAreAskedForOnce) {
  EXPECT_FALSE(editor_.take_screenshot_request());
  click("command/file.screenshot");
  EXPECT_TRUE(editor_.take_screenshot_request());
  EXPECT_FALSE(editor_.take_screenshot_request());
  EXPECT_FALSE(editor_.wants_to_quit());
}

}  // namespace
}  // namespace griffith::app
