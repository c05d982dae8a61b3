// What the outliner, the gizmo and the handles of regions do to the scene of a running editor.

#include <functional>

#include "editor_fixture.h"
#include "sim/scene/scene_writer.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
namespace {

class EditorEntries : public EditorTest {
 protected:
  void drag(const std::string& tag, float dx, float dy) {
    const ui::WidgetTag* widget = ui::find_tag(editor_.tags(), tag);
    ASSERT_NE(widget, nullptr) << tag;
    ui::drag(queue_, widget->center(), {dx, dy});
    play();
    wait_for_work();
  }
  void execute(std::string_view name) {
    editor_.execute({.name = name});
    draw();
    wait_for_work();
  }
  /// Selects an entry even if the list does not show it.
  void choose(const ui::SceneEntry& entry) {
    ui::select_entries(editor_.state(), editor_.document().scene(), {entry});
    draw(2);
  }
  std::string text() const { return scene_to_json(editor_.document().scene()); }
};

TEST_F(EditorEntries, EachEditIsOneEntryOfTheHistoryAndComesBackToTheSameBytes) {
  const std::vector<std::pair<const char*, std::function<void()>>> edits = {
      {"add a support", [&] { execute("add.support"); }},
      {"drag a face of its region", [&] { drag("region/3", 4, -40); }},
      {"move its region", [&] { press_key('G'), drag("gizmo/move_y", 0, -30); }},
      {"add a load", [&] { execute("add.load"); }},
      {"add a probe", [&] { execute("add.probe"); }},
      {"move the probe", [&] { drag("gizmo/move_xy", 20, -10); }},
      {"rename the probe", [&] { press_key(ui::key::kF1 + 1), draw(4), type("tip"), press_key(ui::key::kEnter); }},
      {"duplicate the probe", [&] { press_key('D', true); }},
      {"add a shot", [&] { execute("add.projectile"); }},
      {"turn a shot",
       [&] {
         choose({ui::EntryKind::projectile, 0}), drag("gizmo/turn_y", 40, 5);
       }},
      {"add a camera", [&] { execute("add.camera"); }},
      {"set it",
       [&] { editor_.viewport().use_camera(editor_.document().scene(), "side"), draw(), execute("view.set_camera"); }},
      {"turn a body",
       [&] {
         editor_.viewport().use_camera(editor_.document().scene(), "front"), choose({ui::EntryKind::body, 0}),
             drag("gizmo/turn_y", 40, 5);
       }},
      {"delete a support",
       [&] {
         choose({ui::EntryKind::support, 0, 0}), press_key(ui::key::kDelete);
       }},
      {"delete the body", [&] {
         choose({ui::EntryKind::body, 0}), press_key(ui::key::kDelete);
       }}};
  std::vector<std::string> texts = {text()};
  for (const auto& [name, edit] : edits) {
    edit();
    wait_for_work();
    EXPECT_FALSE(editor_.state().error) << name;
    texts.push_back(text());
    EXPECT_NE(texts.back(), texts[texts.size() - 2]) << name;
  }
  for (std::size_t i = edits.size(); i-- > 0;) {
    execute("edit.undo");
    EXPECT_EQ(text(), texts[i]) << "undo " << edits[i].first;
  }
  EXPECT_NE(editor_.disabled_reason("edit.undo"), "") << "each was one entry";
  for (std::size_t i = 0; i < edits.size(); ++i) {
    execute("edit.redo");
    EXPECT_EQ(text(), texts[i + 1]) << "redo " << edits[i].first;
  }
}

TEST_F(EditorEntries, ACameraFromTheViewShowsWhatTheViewShowed) {
  for (int i = 0; i < 3; ++i) editor_.run().step();
  drag("viewport", 60, 35);
  execute("add.camera");
  const Camera wanted = editor_.document().scene().cameras.back();
  drag("viewport", -90, 10);
  const auto shown = [&] {
    execute("add.camera");
    Camera camera = editor_.document().scene().cameras.back();
    execute("edit.undo");
    camera.name = wanted.name;
    return camera;
  };
  EXPECT_NE(shown(), wanted);
  click("cameras/0/look");
  EXPECT_EQ(shown().position, Vec3(2, 2, 5)) << "in as few digits as it had";
  click("cameras/2/look");
  EXPECT_EQ(shown(), wanted) << "to the bit";
  EXPECT_EQ(editor_.run().frame().step, 3) << "cameras are none of the simulation's business";
}

TEST_F(EditorEntries, ARegionThatIsDraggedHoldsTheNodesInIt) {
  execute("add.support");
  const auto held = [&] { return std::ranges::count(editor_.run().frame().nodes.has_support, 1); };
  const auto at_the_foot = held();
  ASSERT_GT(at_the_foot, 0);
  drag("region/3", 0, -600);
  EXPECT_GT(held(), at_the_foot);
}

}  // namespace
}  // namespace griffith::app
