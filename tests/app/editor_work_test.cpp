#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/editor/editor.h"
#include "editor_fixture.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

/// A tetrahedron whose legs are this long [m].
std::string tet_surface(const std::string& leg) {
  return "OFF\n4 4 0\n0 0 0\n" + leg + " 0 0\n0 " + leg + " 0\n0 0 " + leg + "\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

/// Enters a surface to be filled on the lattice, with elements of this size [m].
void enter(ui::SurfaceRequest& request, const std::string& file, double element_size) {
  std::copy(file.begin(), file.end(), request.path.begin());
  request.method = MeshingMethod::volumetric;
  request.automatic_size = false;
  request.element_size = element_size;
}

TEST_F(EditorTest, WorkThatLastsShowsADialogThatCancelsIt) {
  Scene scene = small_wall();
  test_file("ball.off", tet_surface("1"));
  SurfaceShape shape;
  shape.path = test_folder() / "ball.off";
  shape.meshing.method = MeshingMethod::volumetric;
  shape.meshing.element_size = 0.01;  // two million lattice vertices
  scene.bodies[0].shape = shape;
  scene.bodies[0].supports.clear();
  const auto path = test_folder() / "ball.json";
  write_scene(scene, path);
  const std::string before = editor_.document().title();
  editor_.builder().open(path);
  insist();
  const auto begins = [&] {
    const std::string stage = value("work/stage");
    return stage == "Building bodies" || stage == "Meshing body 1 of 1" || stage == "Checking the surface";
  };
  for (int i = 0; i < 600 && begins(); ++i) draw_while_working();
  EXPECT_THAT(value("work/stage"),
              ::testing::AnyOf("Filling with tetrahedra", "Finding the inside", "Finding the border"));
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_EQ(editor_.document().title(), before);
  EXPECT_FALSE(editor_.state().error);
}

TEST_F(EditorTest, TheFirstPictureOfASceneThatTookLongIsItsOwn) {
  Scene scene = small_wall();
  std::get<BoxShape>(scene.bodies[0].shape).element_size = Vec3::Constant(0.04);
  scene.cameras = {{"away", Vec3(0, 1, 50), Vec3(0, 1, 100), 40}};
  scene.name = "behind";
  write_scene(scene, test_folder() / "behind.json");
  EXPECT_GT(hits_across(), 0);
  editor_.builder().open(test_folder() / "behind.json");
  ASSERT_NE(editor_.state().work, "");
  for (int i = 0; i < 6000 && !editor_.document().title().starts_with("behind"); ++i) draw_while_working();
  EXPECT_EQ(hits_across(), 0);
}

TEST_F(EditorTest, AMeshThatWouldBeHugeAsksFirst) {
  const std::size_t tets = editor_.run().frame().elements.tets.size();
  const std::string before = editor_.document().title();
  Scene scene = small_wall();
  BoxShape box;
  box.element_size = Vec3::Constant(0.011);
  scene.bodies[0].shape = box;
  write_scene(scene, test_folder() / "fine.json");
  editor_.builder().open(test_folder() / "fine.json");
  wait_for_work();
  EXPECT_THAT(value("large_mesh/text"), ::testing::HasSubstr("about 3,800,000 tetrahedra"));
  click("large_mesh/cancel");
  EXPECT_EQ(editor_.document().title(), before);
  EXPECT_EQ(editor_.run().frame().elements.tets.size(), tets);
  EXPECT_FALSE(editor_.state().large_mesh);
}

TEST_F(EditorTest, AnEditThatWouldMakeAHugeMeshCanBeTakenBack) {
  const std::size_t tets = editor_.run().frame().elements.tets.size();
  click("body");
  click("body/shape");
  click("body/shape/kind_of");
  click("body/shape/kind_of/sphere");
  wait_for_work();
  const std::size_t of_sphere = editor_.run().frame().elements.tets.size();
  EXPECT_NE(of_sphere, tets);
  click("body/shape/sphere/element_size", 1);
  for (const char letter : std::string("9 mm")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
  draw();
  EXPECT_EQ(value("typed_meaning"), "= 9 mm");
  click("view/shading");
  wait_for_work();
  EXPECT_NE(value("large_mesh/text"), "no widget large_mesh/text");
  click("large_mesh/cancel");
  EXPECT_EQ(editor_.run().frame().elements.tets.size(), of_sphere);
  EXPECT_EQ(value("body/shape/sphere/element_size"), "200 mm");
}

TEST_F(EditorTest, AnEditedShapeStartsTheSimulationAgainAndTheEditCanBeUndone) {
  const std::size_t tets = editor_.run().frame().elements.tets.size();
  editor_.run().step();
  EXPECT_EQ(editor_.run().frame().step, 1);
  click("body");
  click("body/remeshing");
  wait_for_work();
  EXPECT_EQ(editor_.run().frame().step, 0);
  click("body/shape");
  click("body/shape/kind_of");
  click("body/shape/kind_of/sphere");
  wait_for_work();
  EXPECT_NE(editor_.run().frame().elements.tets.size(), tets);
  click("command/edit.undo");
  wait_for_work();
  EXPECT_EQ(editor_.run().frame().elements.tets.size(), tets);
  EXPECT_FALSE(editor_.state().error);
}

TEST_F(EditorTest, ABodyIsFilledFromASurfaceAndTheEditCanBeUndone) {
  const std::string file = test_file("ball.off", tet_surface("1")).string();
  click("menu/Add");
  click("menu/file.add_surface");
  draw(4);
  enter(editor_.state().surface, file, 0.2);
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
  const std::string file = test_file("ball.off", tet_surface("1")).string();
  enter(editor_.state().surface, file, 0.01);  // two million lattice vertices
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

TEST_F(EditorTest, ABrokenFileOpenedDuringWorkLeavesTheWorkAndTheEdits) {
  const std::string file = test_file("ball.off", tet_surface("1")).string();
  click("material/yields");
  enter(editor_.state().surface, file, 0.05);
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  editor_.builder().open(test_file("broken.json", "{\"bodies\": ["));
  wait_for_work();
  ASSERT_TRUE(editor_.state().error);
  click("error/close");
  draw(4);
  click("report/close");
  EXPECT_EQ(value("bodies/1"), "ball");
  EXPECT_NE(editor_.document().title().find('*'), std::string::npos) << "nothing was saved";
  click("command/edit.undo");
  EXPECT_EQ(value("bodies/1"), "no widget bodies/1");
  click("command/edit.undo");
  EXPECT_EQ(editor_.document().title().find('*'), std::string::npos);
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
  editor_.builder().open(path);
  draw();
  wait_for_work();
  ASSERT_FALSE(editor_.state().error) << editor_.state().error->where << ": " << editor_.state().error->problem;
  const std::string file = test_file("ball.off", tet_surface("1")).string();
  enter(editor_.state().surface, file, 0.2);
  editor_.state().show_surface = true;
  draw(4);
  click("surface/fill");
  wait_for_work();
  ASSERT_FALSE(editor_.state().error) << editor_.state().error->where << ": " << editor_.state().error->problem;
  click("report/close");
  ASSERT_EQ(value("bodies/1"), "ball");
  const std::size_t tets = editor_.run().frame().elements.tets.size();
  test_file("grown.off", tet_surface("1.2"));  // 1,728 times the elements
  click("command/edit.undo");
  insist();
  ASSERT_NE(value("work/stage"), "no widget work/stage");
  click("work/cancel");
  draw(2);
  EXPECT_TRUE(editor_.state().work.empty());
  EXPECT_EQ(value("bodies/1"), "ball");
  EXPECT_EQ(editor_.run().frame().elements.tets.size(), tets);
  EXPECT_FALSE(editor_.state().error);
}

}  // namespace
}  // namespace griffith::app
