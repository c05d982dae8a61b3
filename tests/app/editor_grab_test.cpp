#include <gmock/gmock.h>

#include <filesystem>

#include "editor_fixture.h"
#include "sim/recording/replay.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

/// The brick wall, broken by its ball, with a brick of its heap in the hand of the user.
class EditorGrab : public EditorTest {
 protected:
  EditorGrab() : EditorTest(broken_wall()) {}

  static Scene broken_wall() {
    Scene scene = small_wall();
    scene.bodies[0].material.tensile_strength *= 0.05;
    scene.bodies[0].material.fracture_toughness *= 0.05;
    scene.bodies[0].supports.clear();
    return scene;
  }

  void make_steps(int count) {
    for (int i = 0; i < count; ++i) editor_.execute({.name = "simulation.step"});
    draw(2);
  }

  Frame frame() const { return editor_.run().frame(); }

  /// Returns a point of the picture in the middle of a few on a body of the world, 0..1.
  Vec2 place_of_body() {
    constexpr int kOnBody = 3;
    for (int i = 0, found = 0; i < 100; ++i) {
      const Vec2 place(0.3 + 0.004 * i, 0.6);
      editor_.execute({.name = "view.pick", .cursor = place});
      found = editor_.state().selection.valid() ? found + 1 : 0;
      if (found == kOnBody) return place - Vec2(0.004, 0);
    }
    ADD_FAILURE() << "no body in the picture";
    return {0.5, 0.5};
  }

  ImVec2 pixel(const Vec2& place) const {
    const ui::EditorState& state = editor_.state();
    return {state.viewport_minimum.x + static_cast<float>(place.x()) * state.viewport_size.x,
            state.viewport_minimum.y + static_cast<float>(place.y()) * state.viewport_size.y};
  }

  /// Presses the left button at a point of the view.
  void press_at(const Vec2& place) {
    queue_.move(pixel(place));
    queue_.end_frame();
    queue_.button(0, true);
    play();
    draw(2);
  }
  void move_to(const Vec2& place) {
    queue_.move(pixel(place));
    play();
    draw();
  }
  void release_button() {
    queue_.button(0, false);
    play();
    draw(2);
  }
};

TEST_F(EditorGrab, AScriptDragsAPieceTowardTheCursor) {
  make_steps(20);
  const Vec2 place = place_of_body();
  editor_.execute({.name = "simulation.grab_at", .cursor = place});
  ASSERT_TRUE(frame().grab);
  const GrabView start = *frame().grab;
  EXPECT_LT((start.point - start.target).norm(), 1e-9);
  editor_.execute({.name = "simulation.drag_to", .cursor = place - Vec2(0, 0.3)});
  draw();
  EXPECT_THAT(value("grab/readout"), HasSubstr("0 N of "));
  make_steps(1);
  const GrabView pulled = *frame().grab;
  EXPECT_GT(pulled.target.y(), start.target.y());
  const Vec3 sight = (editor_.viewport().camera().target - editor_.viewport().camera().position).cast<double>();
  EXPECT_LT(std::abs(sight.normalized().dot(pulled.target - start.target)), 1e-5) << "in a plane parallel to the view";
  make_steps(240);
  const GrabView end = *frame().grab;
  EXPECT_LT((end.target - end.point).norm(), 0.2 * (pulled.target - start.point).norm());
  EXPECT_THAT(value("grab/readout"), HasSubstr("N of "));
  const EnergyAccount energy = frame().energy;
  EXPECT_GT(energy.loads, 0);
  EXPECT_LT(std::abs(energy.unaccounted()), 0.01 * energy.turned_over());
}

TEST_F(EditorGrab, RewindAndReplayRepeatItToTheBit) {
  make_steps(20);
  const Vec2 place = place_of_body();
  editor_.execute({.name = "simulation.grab_at", .cursor = place});
  for (int i = 1; i <= 10; ++i) {
    editor_.execute({.name = "simulation.drag_to", .cursor = place - Vec2(0.01 * i, 0.02 * i)});
    make_steps(2);
  }
  editor_.execute({.name = "simulation.release"});
  make_steps(10);
  const std::uint64_t end = editor_.run().world().state_hash();
  editor_.execute({.name = "time.step", .step = 31});
  EXPECT_TRUE(frame().grab) << "the past shows it";
  EXPECT_FALSE(editor_.state().holds_piece);
  make_steps(19);
  EXPECT_EQ(editor_.run().world().state_hash(), end);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u);
  std::filesystem::remove(test_folder() / "grab.tar.zst");
  editor_.execute({.name = "file.write_recording", .path = test_folder() / "grab.tar.zst"});
  const Recording recording = read_recording(test_folder() / "grab.tar.zst");
  EXPECT_EQ(recording.inputs.size(), 12u);
  Replay replay(recording);
  while (!replay.at_end()) replay.advance();
  EXPECT_FALSE(replay.difference());
}

TEST_F(EditorGrab, ABranchInThePastLetsGo) {
  make_steps(20);
  editor_.execute({.name = "simulation.grab_at", .cursor = place_of_body()});
  make_steps(10);
  editor_.execute({.name = "time.step", .step = 25});
  editor_.execute({.name = "simulation.fire", .cursor = Vec2(0.9, 0.1)});
  make_steps(2);
  EXPECT_FALSE(frame().grab) << "nobody holds it any more";
}

TEST_F(EditorGrab, TheMouseGrabsDragsAndReleases) {
  make_steps(20);
  const Vec2 place = place_of_body();
  const Eigen::Vector3f eye = editor_.viewport().camera().position;
  press_at(place);
  EXPECT_FALSE(frame().grab) << "the tool is off";
  release_button();
  press_key('D');
  EXPECT_TRUE(editor_.state().grab_tool);
  press_at(place);
  ASSERT_TRUE(frame().grab);
  const Vec3 start = frame().grab->target;
  for (int i = 1; i <= 10; ++i) {
    move_to(place - Vec2(0, 0.02 * i));
    make_steps(1);
  }
  ASSERT_TRUE(frame().grab);
  EXPECT_GT(frame().grab->target.y(), start.y());
  EXPECT_EQ(editor_.viewport().camera().position, eye) << "the view stays";
  release_button();
  EXPECT_FALSE(frame().grab);
  press_at(place);
  if (frame().grab) press_key(ui::key::kEscape);
  EXPECT_FALSE(frame().grab);
}

TEST_F(EditorGrab, BesideAPieceTheViewIsRotated) {
  press_key('D');
  const Eigen::Vector3f eye = editor_.viewport().camera().position;
  press_at(Vec2(0.02, 0.05));
  EXPECT_FALSE(frame().grab);
  move_to(Vec2(0.12, 0.05));
  move_to(Vec2(0.22, 0.05));
  release_button();
  EXPECT_GT((editor_.viewport().camera().position - eye).norm(), 0.1f);
}

TEST_F(EditorGrab, AStaticAnalysisRefusesIt) {
  editor_.document().history().change("Set analysis", [](Scene& scene) { scene.analysis = Analysis::static_; });
  for (const char* tool : {"simulation.grab", "simulation.push"})
    EXPECT_THAT(std::string(editor_.disabled_reason(tool)), HasSubstr("nothing moves"));
}

TEST_F(EditorGrab, AClickWithTheToolPushesAlongTheLineOfSight) {
  make_steps(20);
  const Vec2 place = place_of_body();
  press_key('I');
  EXPECT_TRUE(editor_.state().push_tool);
  editor_.state().push_speed = 3;
  const double mass = frame().bodies[frame().elements.bodies[editor_.state().selection.tet]].mass;
  const Vec3 before = frame().totals.momentum;
  move_to(place);
  draw(2);
  EXPECT_THAT(value("push/readout"), HasSubstr("3 m/s on "));
  press_at(place);
  release_button();
  EXPECT_EQ(editor_.run().timeline().inputs().size(), 1u);
  ASSERT_TRUE(editor_.state().push_mark);
  const Vec3 impulse = editor_.state().push_mark->impulse;
  EXPECT_NEAR(impulse.norm(), 3 * mass, 1e-9 * mass);
  const Vec3 sight =
      (editor_.state().push_mark->point - editor_.viewport().camera().position.cast<double>()).normalized();
  EXPECT_GT(impulse.normalized().dot(sight), 0.999) << "away from the eye, through the point";
  make_steps(1);
  EXPECT_NE(frame().totals.momentum, before);
  EXPECT_GT(frame().energy.loads, 0);
  press_key('D');
  EXPECT_FALSE(editor_.state().push_tool) << "one tool at a time";
}

TEST_F(EditorGrab, APushGivesLightAndHeavyPiecesTheSameSpeed) {
  const auto velocity = [&]() -> Vec3 {
    double mass = 0;
    for (const BodyView& body : frame().bodies) mass += body.mass;
    return frame().totals.momentum / mass;
  };
  for (const double density : {20.0, 2e4}) {
    editor_.document().history().change("free", [&](Scene& scene) {
      scene.gravity = Vec3::Zero();
      scene.ground.reset();
      scene.projectiles.clear();
      scene.bodies[0].material.density = density;
    });
    editor_.document().history().finish();
    draw();
    wait_for_work();
    const Vec3 before = velocity();
    editor_.execute({.name = "simulation.push_at", .cursor = place_of_body()});
    make_steps(1);
    EXPECT_NEAR((velocity() - before).norm(), editor_.state().push_speed, 1e-6) << density;
  }
}

TEST_F(EditorGrab, PushesAreRepeatedToTheBit) {
  make_steps(10);
  const Vec2 place = place_of_body();
  editor_.state().push_speed = 5;
  editor_.execute({.name = "simulation.push_at", .cursor = place});
  make_steps(20);
  const std::uint64_t end = editor_.run().world().state_hash();
  editor_.execute({.name = "time.step", .step = 5});
  make_steps(25);
  EXPECT_EQ(editor_.run().world().state_hash(), end);
  std::filesystem::remove(test_folder() / "push.tar.zst");
  editor_.execute({.name = "file.write_recording", .path = test_folder() / "push.tar.zst"});
  const Recording recording = read_recording(test_folder() / "push.tar.zst");
  EXPECT_EQ(recording.inputs.size(), 1u);
  Replay replay(recording);
  while (!replay.at_end()) replay.advance();
  EXPECT_FALSE(replay.difference());
}

TEST_F(EditorGrab, APushBesideAPieceDoesNothing) {
  press_key('I');
  press_at(Vec2(0.02, 0.05));
  release_button();
  EXPECT_TRUE(editor_.run().timeline().inputs().empty());
}

}  // namespace
}  // namespace griffith::app
