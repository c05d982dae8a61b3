#include "ui/model/input_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/random_values.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

/// The editor in a window that draws so seldom that all events of a test come between two frames.
struct SlowWindow {
  UiDriver ui{two_walls()};
  InputQueue queue;

  SlowWindow() { ImGui::GetIO().DeltaTime = 0.125f; }

  void frame() {
    queue.play(ImGui::GetIO());
    ui.frame();
  }
  int draw_all() {
    int frames = 0;
    for (; !queue.empty() && frames < 10000; ++frames) frame();
    for (int i = 0; i < 3; ++i) frame();
    return frames;
  }
  void click(const std::string& tag, int button) {
    queue.move(ui.find(tag));
    queue.button(button, true);
    queue.button(button, false);
  }
  void tap(int key) {
    queue.key(key, true);
    queue.key(key, false);
  }
  void tap_with(int modifier, int key) {
    queue.key(modifier, true);
    tap(key);
    queue.key(modifier, false);
  }
  /// As a keyboard writes it, with its keys and Shift.
  void type(const std::string& text) {
    for (const char letter : text) {
      const bool shift = letter >= 'A' && letter <= 'Z';
      const int key = letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter;
      if (shift) queue.key(key::kLeftShift, true);
      queue.key(key, true);
      queue.text(static_cast<unsigned char>(letter));
      queue.key(key, false);
      if (shift) queue.key(key::kLeftShift, false);
    }
  }
  std::vector<std::string_view> ids() const {
    std::vector<std::string_view> result;
    for (const Command& command : ui.commands) result.push_back(command.name);
    return result;
  }
};

constexpr int kEnter = 257;

TEST(InputQueue, AClickHitsWhatIsUnderTheCursorAfterAScriptHasMovedTheMouse) {
  SlowWindow window;
  const ImVec2 cursor = window.ui.find("command/simulation.step");
  window.queue.move(cursor);
  window.queue.move(window.ui.find("material/density"));  // as a script does
  window.draw_all();
  for (int i = 0; i < 2; ++i) {
    window.queue.expect_at(cursor);
    window.queue.button(0, true);
    window.queue.button(0, false);
    window.draw_all();
  }
  EXPECT_THAT(window.ids(), ::testing::ElementsAre("simulation.step", "simulation.step"));
  EXPECT_EQ(ImGui::GetIO().MousePos.x, cursor.x);
  window.queue.expect_at(cursor);
  EXPECT_TRUE(window.queue.empty()) << "it is there";
}

TEST(InputQueue, ATapOfAShortcutWithinAFrameIssuesItsCommandOnce) {
  SlowWindow window;
  window.tap_with(key::kLeftControl, 'O');
  window.draw_all();
  EXPECT_THAT(window.ids(), ::testing::ElementsAre("file.open"));
  window.tap('N');
  window.tap('N');
  window.tap_with(key::kRightControl, 'S');
  window.tap('N');
  EXPECT_LE(window.draw_all(), 8);
  EXPECT_THAT(window.ids(), ::testing::ElementsAre("file.open", "simulation.step", "simulation.step", "file.save",
                                                   "simulation.step"));
}

TEST(InputQueue, AValueIsTypedBetweenTwoFrames) {
  SlowWindow window;
  window.click("material/young_modulus", 1);
  window.type("20 GPa");
  window.tap(kEnter);
  EXPECT_LE(window.draw_all(), 12);
  EXPECT_EQ(window.ui.history.scene().bodies[0].material.young_modulus, 20e9);
  EXPECT_TRUE(window.ui.commands.empty());
}

TEST(InputQueue, AllOfAFieldIsChosenAndReplaced) {
  SlowWindow window;
  window.click("material/young_modulus", 1);
  window.type("5");
  window.tap_with(key::kLeftControl, 'A');
  window.type("20 MPa");
  window.tap(kEnter);
  window.tap_with(key::kLeftControl, 'Z');
  window.draw_all();
  EXPECT_EQ(window.ui.history.entries().at(0).after.bodies[0].material.young_modulus, 20e6);
  EXPECT_THAT(window.ids(), ::testing::ElementsAre("edit.undo"));
}

TEST(InputQueue, ADragWithinAFrameDoesWhatASlowOneDoes) {
  constexpr const char* kTag = "material/young_modulus";
  SlowWindow window;
  const ImVec2 start = window.ui.find(kTag);
  window.queue.move(start);
  window.queue.button(0, true);
  for (int i = 1; i <= 30; ++i) window.queue.move({start.x + static_cast<float>(i), start.y});
  window.queue.button(0, false);
  window.queue.move({5, 5});
  window.draw_all();
  const Scene dragged = window.ui.history.scene();
  EXPECT_EQ(window.ui.history.entries().size(), 1u);
  window.ui.history.undo();
  window.ui.drag(kTag, 30);
  EXPECT_EQ(dragged, window.ui.history.scene());
}

TEST(InputQueue, KeysKeepTheModifiersThatTheyWerePressedWith) {
  SlowWindow window;
  window.ui.history.change("a", [](Scene& scene) { scene.name = "a"; });
  window.queue.key(key::kLeftControl, true);
  window.queue.key('Z', true);
  window.queue.key(key::kLeftControl, false);
  window.queue.key('Z', false);
  window.tap('E');
  window.draw_all();
  EXPECT_THAT(window.ids(), ::testing::ElementsAre("edit.undo", "view.edges"));
}

// ImGui ends the program where modifiers change while a frame is drawn.
TEST(InputQueue, RandomEventsEndAsTheyCameAndStopNothing) {
  testing::RandomValues random(5);
  SlowWindow window;
  std::array<bool, 512> down = {};
  for (int i = 0; i < 4000; ++i) {
    const int which = random.index(10);
    const int key = which < 4 ? key::kFirstModifier + random.index(8) : 'A' + random.index(26);
    down[static_cast<std::size_t>(key)] = random.index(2) == 0;
    window.queue.key(key, down[static_cast<std::size_t>(key)]);
    if (which == 4) window.queue.text(static_cast<unsigned int>('0' + random.index(10)));
    if (which == 5) window.queue.button(random.index(3), random.index(2) == 0);
    if (which == 6) window.queue.scroll(0, 1);
    window.queue.move({static_cast<float>(random.index(1500)), static_cast<float>(random.index(940))});
    if (random.index(3) == 0) window.frame();
  }
  for (int i = 0; i < 512; ++i) window.queue.key(i, false);
  window.draw_all();
  EXPECT_TRUE(window.queue.empty());
  const ImGuiIO& io = ImGui::GetIO();
  EXPECT_FALSE(io.KeyCtrl || io.KeyShift || io.KeyAlt || io.KeySuper);
}

}  // namespace
}  // namespace griffith::ui
