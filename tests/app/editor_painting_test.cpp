#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor_fixture.h"
#include "ui/model/entry_choice.h"
#include "ui/model/painted_region.h"

namespace griffith::app {
namespace {

using ::testing::IsSubsetOf;

/// Two blocks of different meshes, the second behind the first; the first is turned and held at its foot.
Scene two_blocks() {
  Scene scene;
  scene.ground.reset();
  for (int i = 0; i < 2; ++i) {
    BodyDescription block;
    block.name = i == 0 ? "front" : "back";
    block.shape = BoxShape{Vec3(2, 2, 0.1), Vec3(0.25 + 0.15 * i, 0.25, 0.1)};
    block.position = Vec3(0, 0, -i);
    scene.bodies.push_back(block);
  }
  scene.bodies[0].rotation_degrees = Vec3(0, 0, 30);
  scene.bodies[0].supports = {{BoxRegion{Vec3(-1, -1, -1), Vec3(1, -0.7, 1)}}};
  return scene;
}

std::set<int> held_nodes(const Frame& frame) {
  std::set<int> nodes;
  for (std::size_t i = 0; i < frame.nodes.points.size(); ++i)
    if (frame.nodes.has_support[i]) nodes.insert(frame.nodes.points[i]);
  return nodes;
}

TEST(PaintedRegion, BeginsWithTheNodesThatTheRegionHolds) {
  const Scene scene = two_blocks();
  const World world(scene);
  const std::set<int> nodes = ui::nodes_in_region(world.frame(), scene, 0, scene.bodies[0].supports[0].region);
  EXPECT_EQ(nodes, held_nodes(world.frame()));
  EXPECT_FALSE(nodes.empty());
  const NodeListRegion listed{{nodes.begin(), nodes.end()}};
  EXPECT_EQ(ui::nodes_in_region(world.frame(), scene, 0, listed), nodes);
  EXPECT_EQ(ui::places_of_nodes(world.frame(), 0, nodes).size(), nodes.size());
}

TEST(PaintedRegion, GoesByThePointsOfAFileThatHasSomeToSpare) {
  Scene scene;
  scene.ground.reset();
  BodyDescription body;
  body.shape = MeshFileShape{test_file("spare.mesh",
                                       "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n9 9 9 0\n0 0 0 0\n1 0 0 0\n"
                                       "0 1 0 0\n8 8 8 0\n0 0 1 0\nTetrahedra\n1\n2 3 4 6 0\nEnd\n")};
  body.supports = {{NodeListRegion{{1, 5}}}};
  scene.bodies = {body};
  const World world(scene);
  EXPECT_THAT(held_nodes(world.frame()), ::testing::ElementsAre(1, 5));
  EXPECT_THAT(ui::nodes_in_region(world.frame(), scene, 0, BoxRegion{Vec3::Zero(), Vec3(0, 0, 1)}),
              ::testing::ElementsAre(1, 5));
}

TEST(PaintedRegion, ABrushReachesTheSideThatIsSeenOfItsBodyAlone) {
  const World world(two_blocks());
  const Frame frame = world.frame();
  const ui::ViewRay ray{Vec3(0.1, 0.2, 5), Vec3(0, 0, -1)};
  const std::optional<Vec3> place = ui::place_on_body(frame, 0, ray);
  ASSERT_TRUE(place);
  EXPECT_LT((*place - Vec3(0.1, 0.2, 0.05)).norm(), 1e-6);
  EXPECT_FALSE(ui::place_on_body(frame, 1, ray)) << "the other is in front of it";
  EXPECT_FALSE(ui::place_on_body(frame, 0, {Vec3(5, 0, 5), Vec3(0, 0, -1)}));
  const std::set<int> nodes = ui::nodes_under_brush(frame, 0, *place, ray.direction, 0.5);
  EXPECT_GT(nodes.size(), 5u);
  for (const Vec3& node : ui::places_of_nodes(frame, 0, nodes)) {
    EXPECT_GT(node.z(), 0) << "the plate is thinner than the brush";
    EXPECT_LE((node - *place).norm(), 0.5);
  }
  EXPECT_EQ(ui::nodes_under_brush(frame, 0, *place, ray.direction, 1e-6).size(), 1u) << "the nearest";
}

class EditorPaintingTest : public EditorTest {
 protected:
  EditorPaintingTest() {
    ui::select_entries(editor_.state(), editor_.document().scene(), {{ui::EntryKind::support, 0}});
    draw(2);
    press_key('T');
    draw(2);
  }

  std::set<int> region() const {
    const auto* list = std::get_if<NodeListRegion>(&editor_.document().scene().bodies[0].supports[0].region);
    return list ? std::set<int>(list->nodes.begin(), list->nodes.end()) : std::set<int>();
  }

  /// Where a face of the region's box is seen.
  Vec2 grip_in_view() {
    const ui::WidgetTag* grip = ui::find_tag(editor_.tags(), "region/3");
    return grip ? Vec2(grip->center().x, grip->center().y) : Vec2(Vec2::Zero());
  }

  /// Draws a line with the brush; from and to are parts of the view.
  void stroke(Vec2 from, Vec2 to, bool ctrl = false) {
    const ui::EditorState& state = editor_.state();
    const auto at = [&](const Vec2& place) {
      return ImVec2(state.viewport_minimum.x + static_cast<float>(place.x()) * state.viewport_size.x,
                    state.viewport_minimum.y + static_cast<float>(place.y()) * state.viewport_size.y);
    };
    if (ctrl) queue_.key(ui::key::kLeftControl, true);
    const ImVec2 start = at(from), end = at(to);
    ui::drag(queue_, start, {end.x - start.x, end.y - start.y});
    if (ctrl) queue_.key(ui::key::kLeftControl, false);
    play();
    wait_for_work();
  }
};

TEST_F(EditorPaintingTest, NodesUnderTheBrushAreHeldAndOneStrokeIsOneUndo) {
  const std::set<int> before = held_nodes(editor_.run().frame());
  const Vec2 grip = grip_in_view();
  stroke({0.4, 0.5}, {0.6, 0.5});
  const std::set<int> painted = region();
  EXPECT_GT(painted.size(), before.size());
  EXPECT_THAT(before, IsSubsetOf(painted));
  EXPECT_EQ(held_nodes(editor_.run().frame()), painted) << "the world follows";
  stroke({0.4, 0.5}, {0.6, 0.5}, true);
  EXPECT_EQ(region(), before) << "taken off again";
  press_key('Z', true);
  EXPECT_EQ(region(), painted);
  press_key('Z', true);
  EXPECT_TRUE(std::holds_alternative<BoxRegion>(editor_.document().scene().bodies[0].supports[0].region));
  wait_for_work();
  EXPECT_EQ(grip_in_view(), grip) << "the view stood still";
}

TEST_F(EditorPaintingTest, ADragBesideTheBodyTurnsTheView) {
  const Vec2 grip = grip_in_view();
  stroke({0.03, 0.1}, {0.2, 0.3});
  EXPECT_TRUE(region().empty());
  EXPECT_NE(grip_in_view(), grip);
}

}  // namespace
}  // namespace griffith::app
