#include "editor_fixture.h"

namespace griffith::app {
namespace {

class EditorGizmoTest : public EditorTest {
 protected:
  EditorGizmoTest() {
    press_key('G');
    draw(2);
  }

  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Vec3& position : editor_.run().frame().nodes.positions) box.extend(position);
    return box;
  }

  void drag(const std::string& tag, float dx, float dy) {
    const ui::WidgetTag* widget = ui::find_tag(editor_.tags(), tag);
    ASSERT_NE(widget, nullptr) << tag;
    ImGuiIO& io = ImGui::GetIO();
    const ImVec2 start = widget->center();
    io.MousePos = start;
    draw();
    io.MouseDown[0] = true;
    draw();
    for (const float part : {0.3f, 0.7f, 1.0f}) {
      io.MousePos = {start.x + part * dx, start.y + part * dy};
      draw();
    }
    io.MouseDown[0] = false;
    draw();
    wait_for_work();
  }
};

TEST_F(EditorGizmoTest, TheWorldStartsAgainWithTheBodyThere) {
  const Eigen::AlignedBox3d before = box();
  drag("gizmo/move_y", 0, -60);
  EXPECT_GT(box().min().y(), before.min().y() + 0.05);
  EXPECT_NEAR(box().min().x(), before.min().x(), 1e-12);
  press_key('Z', true);
  wait_for_work();
  EXPECT_TRUE(box().isApprox(before)) << "undone";
}

TEST_F(EditorGizmoTest, StandsAtTheBodysOriginInThePicture) {
  const Eigen::AlignedBox3d before = box();
  const ui::WidgetTag* grip = ui::find_tag(editor_.tags(), "gizmo/move_xy");
  ASSERT_NE(grip, nullptr);
  const ImVec2 from = grip->center(), way = {80, -70};
  drag("gizmo/move_xy", way.x, way.y);
  const ui::WidgetTag* after = ui::find_tag(editor_.tags(), "gizmo/move_xy");
  ASSERT_NE(after, nullptr);
  EXPECT_NEAR(after->center().x, from.x + way.x, 8) << "it follows the cursor through the picture's own camera";
  EXPECT_NEAR(after->center().y, from.y + way.y, 8);
  EXPECT_GT(box().center().x(), before.center().x());
}

TEST_F(EditorGizmoTest, WaitsForTheStartOfTime) {
  editor_.run().step();
  draw(2);
  EXPECT_EQ(ui::find_tag(editor_.tags(), "gizmo/move_y"), nullptr);
  press_key('R');
  wait_for_work();
  EXPECT_NE(ui::find_tag(editor_.tags(), "gizmo/move_y"), nullptr);
}

}  // namespace
}  // namespace griffith::app
