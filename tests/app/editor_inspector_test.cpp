#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/editor/editor.h"
#include "editor_fixture.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/scene/scene_writer.h"
#include "sim/world/output/node_report.h"
#include "ui/model/entry_choice.h"
#include "ui/model/units.h"

namespace griffith::app {
namespace {

TEST_F(EditorTest, ClickInTheViewSelectsAnElementOfTheWall) {
  click("viewport");
  EXPECT_TRUE(editor_.state().selection.valid());
  EXPECT_EQ(value("value/Element"), std::to_string(editor_.state().selection.tet.index()));
}

TEST_F(EditorTest, TheOutlinerShowsTheBodyOfTheNodeThatIsExplained) {
  editor_.execute({.name = "add.box"});
  wait_for_work();
  const auto shown = [this] { return ui::active_entry(editor_.state(), editor_.document().scene()); };
  const auto body = [](int index) { return ui::SceneEntry{ui::EntryKind::body, index}; };
  EXPECT_EQ(shown(), body(1));
  select_node(editor_.state(), editor_.run().frame(), NodeId(0));
  draw();
  EXPECT_EQ(shown(), body(0));
  editor_.execute({.name = "add.box"});
  wait_for_work();
  editor_.run().step();
  draw();
  EXPECT_EQ(shown(), body(2)) << "a new body is shown until a node is selected again";
  EXPECT_EQ(editor_.state().selected_body, 2);
}

TEST_F(EditorTest, OfRigidPiecesTheMostLoadedNodeIsThatOfTheLastCrack) {
  const auto frame = [this] { return editor_.run().frame(); };
  const auto is_rigid_debris = [&] { return !frame().crack_events.empty() && !most_loaded_node(frame()).valid(); };
  for (int step = 0; step < 200 && !is_rigid_debris(); ++step) editor_.run().step();
  ASSERT_TRUE(is_rigid_debris());
  editor_.execute({.name = "view.select_most_loaded"});
  EXPECT_EQ(editor_.state().selection.node, frame().crack_events.back().node);
  draw();
  EXPECT_NE(value("inspector/verdict").find("Broke"), std::string::npos) << value("inspector/verdict");
}

/// A wall under fire none of whose pieces becomes rigid.
class ElasticPiecesTest : public EditorTest {
 protected:
  static Scene wall() {
    Scene scene = small_wall();
    scene.simulation.integrator = Integrator::implicit;
    return scene;
  }
  ElasticPiecesTest() : EditorTest(wall()) {}
};

TEST_F(ElasticPiecesTest, SelectionIsExplainedAndSurvivesBreakingAndReset) {
  click("viewport");
  const ui::Selection selected = editor_.state().selection;
  ASSERT_TRUE(selected.valid());
  EXPECT_EQ(value("value/Node"), std::to_string(selected.node.index()));
  for (int i = 0; i < 12; ++i) click("command/simulation.step");
  EXPECT_EQ(editor_.state().selection.rest_position, selected.rest_position);
  EXPECT_NE(value("inspector/verdict").find("resistance"), std::string::npos);
  EXPECT_GE(std::stoi(value("inspector/utilization_plot")), 13);
  const NodeReport report = node_report(editor_.run().frame(), editor_.state().selection.node);
  EXPECT_EQ(value("inspector/element/0"),
            ui::format_quantity(report.elements.front().contribution, report.by_tension ? "Pa" : "N", 3));
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
  const auto& separations = editor_.run().frame().nodes.separations;
  for (const NodeSeparation& separation : separations)
    EXPECT_LE(separation.utilization,
              separations[static_cast<std::size_t>(editor_.state().selection.node)].utilization);
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
  editor_.builder().open(path);
  wait_for_work();
  for (int i = 0; i < 6; ++i) editor_.run().step();
  editor_.state().selected_body = 0;
  press_key('M');
  const NodeId node = editor_.state().selection.node;
  ASSERT_TRUE(node.valid());
  const NodeReport report = node_report(editor_.run().frame(), node);
  EXPECT_EQ(editor_.state().selected_body, editor_.run().frame().bodies[report.body].scene_body);
  EXPECT_EQ(editor_.state().selected_body, 1) << "it is the one that was struck";
  EXPECT_EQ(value("value/Total"), ui::format_quantity(report.sum(), report.by_tension ? "Pa" : "N", 3));
  EXPECT_EQ(value("value/Load now"), ui::format_quantity(report.load, "Pa"));
}

TEST_F(EditorTest, RigidPiecesAreSaidToKeepTheStressThatThePictureShows) {
  Scene scene = small_wall();
  scene.projectiles.clear();
  scene.bodies[0].supports.clear();
  scene.bodies[0].material.tensile_strength = 1e9;
  scene.ground = Ground();
  const auto path = test_folder() / "lying.json";
  write_scene(scene, path);
  editor_.builder().open(path);
  wait_for_work();
  for (int i = 0; i < 60; ++i) editor_.run().step();
  ASSERT_TRUE(editor_.run().frame().bodies[0].rigid);
  press_key('M');
  EXPECT_FALSE(editor_.state().selection.valid());
  EXPECT_THAT(value("status/message"), ::testing::HasSubstr("rigid"));
  EXPECT_THAT(value("status/message"), ::testing::Not(::testing::HasSubstr("without stress")));
  click("viewport");
  ASSERT_TRUE(editor_.state().selection.valid());
  const double stress = von_mises_stress(editor_.run().frame().elements.stresses[editor_.state().selection.tet]);
  ASSERT_GT(stress, 0);
  EXPECT_EQ(value("value/Von Mises stress"), ui::format_quantity(stress, "Pa"));
}

/// The first free node that a load pulls at, of those with one element or with more; invalid where there is none.
NodeId pulled_node(const Frame& frame, bool of_one_element) {
  for (const NodeId node : IdRange<NodeId>(0, static_cast<std::int64_t>(frame.nodes.stars.size()))) {
    const bool wanted =
        (frame.nodes.stars[node].size() == 1) == of_one_element && frame.nodes.constraints[node].is_free();
    if (wanted && node_report(frame, node).load > 0) return node;
  }
  return NodeId();
}

TEST_F(EditorTest, ANodeOfOneElementHasNoEigenvaluesToShow) {
  for (int i = 0; i < 40 && !pulled_node(editor_.run().frame(), true).valid(); ++i) editor_.run().step();
  const NodeId alone = pulled_node(editor_.run().frame(), true),
               among_others = pulled_node(editor_.run().frame(), false);
  ASSERT_TRUE(alone.valid() && among_others.valid());
  select_node(editor_.state(), editor_.run().frame(), alone);
  draw(2);
  EXPECT_EQ(value("value/Eigenvalues"), "none: one element");
  EXPECT_EQ(ui::find_tag(editor_.tags(), "value/Top eigenvector"), nullptr);
  EXPECT_EQ(value("inspector/origin"), "the mean tensile stress of its elements");
  select_node(editor_.state(), editor_.run().frame(), among_others);
  draw(2);
  EXPECT_THAT(value("value/Eigenvalues"), ::testing::HasSubstr("N"));
}

}  // namespace
}  // namespace griffith::app
