// Commands that place bodies: drop, array, mirror, align, presets.

#include <gmock/gmock.h>

#include <random>

#include "app/editor/arrange.h"
#include "app/editor/body_presets.h"
#include "app/editor/placed_surface.h"
#include "app/editor/starting_scene.h"
#include "editor_fixture.h"
#include "sim/core/error.h"
#include "sim/scene/body_pose.h"
#include "sim/scene/scene_writer.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

BodyDescription box(const Vec3& size, const Vec3& position, const Vec3& degrees = Vec3::Zero()) {
  BodyDescription body;
  body.shape = BoxShape{size, size / 2, BoxPattern::five_tet};
  body.position = position;
  body.rotation_degrees = degrees;
  return body;
}

std::optional<double> gap(const BodyDescription& upper, const BodyDescription& lower) {
  return ui::vertical_gap(placed_surface(upper, {}), placed_surface(lower, {}));
}

TEST(VerticalGap, OfCrossedBarsIsThatOfTheirFaces) {
  const BodyDescription along = box(Vec3(2, 0.1, 0.1), Vec3(0, 1, 0)), across = box(Vec3(0.1, 0.1, 2), Vec3::Zero());
  EXPECT_NEAR(gap(along, across).value(), 0.9, 1e-12);
}

TEST(VerticalGap, OfBarsOnTheirEdgesIsThatOfTheCrossingEdges) {
  const BodyDescription upper = box(Vec3(2, 0.1, 0.1), Vec3(0.03, 1, 0.01), Vec3(45, 0, 0));
  const BodyDescription lower = box(Vec3(0.1, 0.1, 2), Vec3::Zero(), Vec3(0, 0, 45));
  EXPECT_NEAR(gap(upper, lower).value(), 1 - 2 * 0.05 * std::sqrt(2), 1e-6);
}

TEST(VerticalGap, GrowsWithTheDistanceAndIsZeroWhereRotatedBoxesTouch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-180, 180), place(-0.3, 0.3);
  for (int i = 0; i < 20; ++i) {
    BodyDescription upper = box(Vec3(0.6, 0.3, 0.5), Vec3(place(random), 3, place(random)),
                                Vec3(angle(random), angle(random), angle(random)));
    const BodyDescription lower =
        box(Vec3(0.5, 0.7, 0.4), Vec3::Zero(), Vec3(angle(random), angle(random), angle(random)));
    const double distance = gap(upper, lower).value();
    upper.position.y() += 1.25;
    EXPECT_NEAR(gap(upper, lower).value(), distance + 1.25, 1e-9);
    upper.position.y() -= 1.25 + distance;
    EXPECT_NEAR(gap(upper, lower).value(), 0, 1e-9);
  }
}

TEST(VerticalGap, DoesNotExistForBodiesSideBySide) {
  EXPECT_FALSE(gap(box(Vec3::Ones(), Vec3(1, 5, 0)), box(Vec3::Ones(), Vec3::Zero())));
  EXPECT_FALSE(gap(box(Vec3::Ones(), Vec3(9, 5, 0)), box(Vec3::Ones(), Vec3::Zero())));
}

class Arrange : public EditorTest {
 protected:
  void execute(std::string_view name) {
    editor_.execute({.name = name});
    draw();
    wait_for_work();
  }
  void choose(std::vector<int> bodies) {
    std::vector<ui::SceneEntry> entries;
    for (const int body : bodies) entries.push_back({ui::EntryKind::body, body});
    ui::select_entries(editor_.state(), editor_.document().scene(), entries);
    draw(2);
  }
  void start_with(std::vector<BodyDescription> bodies) {
    execute("file.new");
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].name = "body " + std::to_string(i);
    editor_.document().history().change("set up", [&](Scene& scene) { scene.bodies = bodies; });
    editor_.document().history().finish();
    draw(2);
    wait_for_work();
  }
  const Scene& scene() const { return editor_.document().scene(); }
  const Vec3& position(std::size_t body) const { return scene().bodies[body].position; }
};

TEST_F(Arrange, DroppedBodiesRestOnTheGroundAndOnEachOther) {
  start_with({box(Vec3(0.2, 0.2, 0.2), Vec3(0, 3, 0)), box(Vec3(0.3, 0.1, 0.3), Vec3(0.05, 1, 0)),
              box(Vec3(0.3, 0.1, 0.3), Vec3(4, 1, 0))});
  choose({0, 1});
  press_key(ui::key::kEnd);
  wait_for_work();
  EXPECT_DOUBLE_EQ(position(1).y(), 0.05) << "on the ground";
  EXPECT_DOUBLE_EQ(position(0).y(), 0.2) << "on the other, which was dropped first";
  EXPECT_EQ(position(2), Vec3(4, 1, 0)) << "was not selected";
  const std::string once = scene_to_json(scene());
  execute("edit.drop");
  EXPECT_EQ(scene_to_json(scene()), once) << "nothing is left to drop";
  execute("edit.undo");
  EXPECT_EQ(position(0).y(), 3);
}

TEST_F(Arrange, ABodyUnderATableStaysUnderIt) {
  start_with({box(Vec3(1, 0.1, 1), Vec3(0, 1, 0)), box(Vec3(0.2, 0.2, 0.2), Vec3(0, 0.5, 0))});
  choose({1});
  execute("edit.drop");
  EXPECT_DOUBLE_EQ(position(1).y(), 0.1);
}

TEST_F(Arrange, NothingBelowIsAnErrorThatNamesTheBody) {
  start_with({box(Vec3::Ones(), Vec3(0, 3, 0))});
  editor_.document().history().change("no ground", [](Scene& scene) { scene.ground.reset(); });
  editor_.document().history().finish();
  wait_for_work();
  choose({0});
  execute("edit.drop");
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->where, HasSubstr("body 0"));
  EXPECT_EQ(position(0).y(), 3);
}

TEST_F(Arrange, AnArrayRepeatsAtEqualDistancesAndIsOneEdit) {
  start_with({box(Vec3(0.4, 0.2, 0.2), Vec3(0, 0.1, 0))});
  choose({0});
  press_key('D', true, true);
  draw(2);
  EXPECT_EQ(value("array/x"), "400 mm") << "side by side at first";
  ui::click(queue_, ui::find_tag(editor_.tags(), "array/count")->center(), 0);
  play();
  type("5");
  press_key(ui::key::kTab);
  click("array/make");
  wait_for_work();
  ASSERT_EQ(scene().bodies.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_TRUE((position(i) - position(i - 1)).isApprox(Vec3(0.4, 0, 0), 1e-12)) << i;
  EXPECT_EQ(ui::selected_bodies(editor_.state(), scene()).size(), 4u) << "the copies";
  execute("edit.undo");
  EXPECT_EQ(scene().bodies.size(), 1u);
}

TEST_F(Arrange, AMirrorImageHasTheMirroredSurfaceAndConditions) {
  BodyDescription tilted = box(Vec3(0.4, 0.2, 0.3), Vec3(1, 0.5, 0.2), Vec3(20, 35, -50));
  tilted.supports = {{BoxRegion{Vec3(-0.2, -0.1, -0.15), Vec3(-0.1, 0.1, 0)}}};
  tilted.velocity = Vec3(1, 2, 3);
  start_with({tilted, box(Vec3(0.2, 0.2, 0.2), Vec3(0.3, 2, 0.4))});
  choose({0, 1});
  execute("edit.mirror_x");
  ASSERT_EQ(scene().bodies.size(), 3u);
  const BodyDescription& image = scene().bodies[2];
  EXPECT_EQ(image.velocity, Vec3(-1, 2, 3));
  const auto mirrored = [](const Vec3& point) { return Vec3(0.6 - point.x(), point.y(), point.z()); };
  Eigen::AlignedBox3d expected;
  for (const Vec3& point : placed_surface(tilted, {}).points) expected.extend(mirrored(point));
  const Eigen::AlignedBox3d found = placed_surface(image, {}).box;
  EXPECT_TRUE(found.isApprox(expected, 1e-8));
  const auto corner = [](const BodyDescription& body, bool high) {
    const auto& region = std::get<BoxRegion>(body.supports[0].region);
    Vec3 local = region.minimum;
    if (high) local.x() = region.maximum.x();
    return pose_of(body).to_world(local);
  };
  EXPECT_TRUE(corner(image, true).isApprox(mirrored(corner(tilted, false)), 1e-8));
}

TEST_F(Arrange, AMirrorImageOfTheMirrorImageIsTheBody) {
  for (const char* mirror : {"edit.mirror_x", "edit.mirror_z"}) {
    start_with({box(Vec3(0.4, 0.2, 0.3), Vec3(1, 0.5, 0.2), Vec3(20, 35, -50))});
    choose({0});
    execute(mirror);
    choose({1});
    execute(mirror);
    ASSERT_EQ(scene().bodies.size(), 3u);
    EXPECT_EQ(position(2), position(0));
    EXPECT_EQ(scene().bodies[2].rotation_degrees, scene().bodies[0].rotation_degrees);
  }
}

TEST_F(Arrange, MirroredTwiceAboutATopOneLegBecomesFour) {
  start_with({box(Vec3(0.1, 0.6, 0.1), Vec3(-0.2, 0.3, -0.5)), box(Vec3(0.8, 0.1, 0.8), Vec3(0.1, 0.65, -0.2))});
  choose({0, 1});
  execute("edit.mirror_x");
  execute("edit.mirror_z");
  ASSERT_EQ(scene().bodies.size(), 5u);
  std::vector<Vec3> legs = {position(0), position(2), position(3), position(4)};
  std::ranges::sort(legs,
                    [](const Vec3& a, const Vec3& b) { return std::pair(a.x(), a.z()) < std::pair(b.x(), b.z()); });
  const std::vector<Vec3> expected = {Vec3(-0.2, 0.3, -0.5), Vec3(-0.2, 0.3, 0.1), Vec3(0.4, 0.3, -0.5),
                                      Vec3(0.4, 0.3, 0.1)};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(legs[i].isApprox(expected[i], 1e-12)) << i;
}

TEST_F(Arrange, AMaterialPresetGoesToAllSelectedBodies) {
  const BodyDescription cube = box(Vec3::Ones(), Vec3(0, 0.5, 0));
  start_with({cube, box(Vec3::Ones(), Vec3(2, 0.5, 0)), box(Vec3::Ones(), Vec3(4, 0.5, 0))});
  choose({2, 0});
  choose_material("granite");
  const Material granite = find_material_preset("granite").value();
  EXPECT_EQ(scene().bodies[0].material, granite);
  EXPECT_EQ(scene().bodies[1].material, cube.material);
  EXPECT_EQ(scene().bodies[2].material, granite);
  execute("edit.undo");
  EXPECT_EQ(scene().bodies[2].material, cube.material) << "one edit";
}

TEST_F(Arrange, AlignedCentersAreLevelWithTheLast) {
  start_with({box(Vec3(0.4, 0.2, 0.3), Vec3(1, 0.5, 0.2), Vec3(20, 0, 0)), box(Vec3::Ones(), Vec3(-1, 2, 3))});
  choose({0, 1});
  execute("edit.align_z");
  EXPECT_EQ(position(1), Vec3(-1, 2, 3));
  const double center = placed_surface(scene().bodies[0], {}).box.center().z();
  EXPECT_NEAR(center, 3, 1e-8);
  EXPECT_EQ(position(0).x(), 1);
}

/// Counts what a hand does: each click, and each key or text typed.
class ByHand : public Arrange {
 protected:
  void press(const std::string& tag) {
    ++inputs_;
    click(tag);
    wait_for_work();
  }
  void press_with_ctrl(const std::string& tag) {
    queue_.key(ui::key::kLeftControl, true);
    press(tag);
    queue_.key(ui::key::kLeftControl, false);
    play();
  }
  void key(int key) {
    ++inputs_;
    press_key(key);
    wait_for_work();
  }
  void enter(const std::string& text) {
    ++inputs_;
    type(text);
  }
  int inputs_ = 0;
};

TEST_F(ByHand, ATableFromAnEmptySceneTakesAtMostFortyInputs) {
  execute("file.new");
  press("menu/Add");
  press("menu/add.plate");
  press("body");
  press("body/position/1");
  enter("800");
  key(ui::key::kEnter);
  press("menu/Add");
  press("menu/add.box");
  press("material/preset");
  press("material/preset/wood, along the grain");
  press("body/shape");
  press("body/shape/box/size/0");
  for (const char* size : {"60", "690", "60"}) {
    enter(size);
    key(ui::key::kTab);
  }
  press("body/position/0");
  enter("-350");
  key(ui::key::kTab);
  key(ui::key::kTab);
  enter("-350");
  key(ui::key::kEnter);
  key(ui::key::kEnd);
  press_with_ctrl("bodies/0");
  for (const char* mirror : {"menu/edit.mirror_x", "menu/edit.mirror_z"}) {
    press("menu/Edit");
    press(mirror);
  }
  press("bodies/0");
  key(ui::key::kEnd);
  EXPECT_LE(inputs_, 40);
  ASSERT_EQ(scene().bodies.size(), 5u);
  EXPECT_NEAR(position(0).y(), 0.7, 1e-9) << "the top lies on the legs";
  for (std::size_t leg = 1; leg < 5; ++leg) {
    EXPECT_NEAR(position(leg).y(), 0.345, 1e-9);
    EXPECT_NEAR(std::abs(position(leg).x()), 0.35, 1e-9);
    EXPECT_NEAR(std::abs(position(leg).z()), 0.35, 1e-9);
  }
  for (int i = 0; i < 30; ++i) editor_.run().step();
  EXPECT_EQ(editor_.run().frame().crack_events.size(), 0u);
}

TEST_F(Arrange, ATableStandsWholeAndABrickWallBreaks) {
  execute("file.new");
  execute("add.table");
  ASSERT_EQ(scene().bodies.size(), 5u);
  EXPECT_TRUE(scene().materials.empty()) << "presets are offered anyway, and files name them";
  const auto height = [&] {
    const Frame frame = editor_.run().frame();
    double top = -1;
    for (const Vec3& position : frame.nodes.positions) top = std::max(top, position.y());
    return top;
  };
  for (int i = 0; i < 60; ++i) editor_.run().step();
  EXPECT_EQ(editor_.run().frame().crack_events.size(), 0u);
  EXPECT_NEAR(height(), 0.71, 0.002);
  execute("edit.undo");
  EXPECT_TRUE(scene().bodies.empty()) << "one edit";
  execute("add.brick_wall");
  editor_.execute({.name = "view.frame_all"});
  editor_.execute({.name = "view.front"});
  editor_.state().shot.speed = 60;
  editor_.execute({.name = "simulation.fire"});
  for (int i = 0; i < 60; ++i) editor_.run().step();
  EXPECT_GT(editor_.run().frame().fragments, 1);
}

TEST_F(Arrange, AVaseStandsWholeNextToTheRest) {
  execute("file.new");
  execute("add.box");
  execute("add.vase");
  ASSERT_EQ(scene().bodies.size(), 2u);
  EXPECT_EQ(scene().bodies[1].name, "vase");
  ASSERT_EQ(scene().materials.size(), 1u) << "offered for others";
  EXPECT_EQ(scene().materials[0], scene().bodies[1].material);
  for (int i = 0; i < 20; ++i) editor_.run().step();
  const Frame frame = editor_.run().frame();
  EXPECT_EQ(frame.crack_events.size(), 0u);
  ASSERT_EQ(frame.bodies.size(), 2u);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i)
    if (frame.bodies[frame.elements.bodies[TetId(static_cast<int>(i))]].scene_body == 1)
      for (const NodeId node : frame.elements.tets[TetId(static_cast<int>(i))]) box.extend(frame.nodes.positions[node]);
  EXPECT_NEAR(box.min().y(), 0, 0.01);
  EXPECT_NEAR(box.max().y(), 0.5, 0.03);
  EXPECT_GT(box.min().x(), 0.25) << "beside the block";
}

TEST(StartingScene, IsBrokenWithinASecondInNaturalColors) {
  const Scene scene = starting_scene();
  EXPECT_EQ(scene.view.quantity, "material");
  World world(scene);
  while (world.frame().time < 1 && world.frame().fragments == 0) world.step();
  EXPECT_GT(world.frame().fragments, 0);
}

TEST_F(Arrange, TheFirstCrackOfAFirstRunIsExplained) {
  editor_.state().explain_first_crack = true;
  editor_.state().shot.speed = 60;
  editor_.execute({.name = "simulation.fire"});
  for (int i = 0; i < 100 && editor_.run().frame().crack_events.empty(); ++i) editor_.run().step();
  draw(2);
  ASSERT_TRUE(editor_.state().selection.valid());
  EXPECT_THAT(value("inspector/verdict"), HasSubstr("Broke at"));
  editor_.state().selection = {};
  for (int i = 0; i < 5; ++i) editor_.run().step();
  EXPECT_FALSE(editor_.state().selection.valid()) << "only the first";
}

TEST_F(Arrange, AxisViewsKeepTargetAndDistance) {
  const render::Camera before = editor_.viewport().camera();
  const std::vector<std::pair<const char*, Vec3>> views = {{"view.front", Vec3::UnitZ()},
                                                           {"view.back", -Vec3::UnitZ()},
                                                           {"view.right", Vec3::UnitX()},
                                                           {"view.left", -Vec3::UnitX()},
                                                           {"view.top", Vec3::UnitY()}};
  for (const auto& [name, toward_eye] : views) {
    execute(name);
    const render::Camera& camera = editor_.viewport().camera();
    EXPECT_EQ(camera.target, before.target);
    const Vec3 arm = (camera.position - camera.target).cast<double>();
    EXPECT_NEAR(arm.norm(), (before.position - before.target).norm(), 1e-5) << name;
    EXPECT_TRUE(arm.normalized().isApprox(toward_eye, 1e-5)) << name;
  }
}

}  // namespace
}  // namespace griffith::app
