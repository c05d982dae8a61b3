#pragma once

#include <imgui.h>

#include <array>
#include <deque>
#include <optional>

namespace griffith::ui {

/// Queue of the window's events for ImGui, in order. ImGui reads the state of keys and buttons once a frame. In a slow
/// frame a tap would begin and end unseen, and a key would get modifiers it was not pressed with. Each frame therefore
/// receives the next events up to the first that would hide an earlier one.
class InputQueue {
 public:
  /// Records that a key (GLFW's numbering, 0..511) went down or up; other codes are ignored.
  void key(int key, bool down);
  /// Records that a mouse button, 0..4, went down or up.
  void button(int button, bool down);
  void move(ImVec2 place);
  /// Records where the mouse is, if its last recorded move led elsewhere, as that of a script does.
  void expect_at(ImVec2 place);
  void scroll(float right, float up);
  void text(unsigned int character);

  /// Defers all later events to a later frame.
  void end_frame();

  /// Passes the events of the next frame to `io`. Call it once a frame, before ImGui::NewFrame().
  void play(ImGuiIO& io);
  bool empty() const { return events_.empty(); }

 private:
  enum class Kind { key, button, move, scroll, text, end_frame };
  struct Event {
    Kind kind;
    int code = 0;  ///< code of the key or button, or the character
    bool down = false;
    ImVec2 place = {};  ///< position, or rotation of the wheel
  };
  /// Events in the current frame so far.
  struct Seen {
    std::optional<Event> act;  ///< a press, a button, the wheel or text
    bool moved = false;
    std::array<bool, IM_ARRAYSIZE(ImGuiIO::KeysDown)> changed_keys = {};
  };

  static bool changes(const Event& event, const ImGuiIO& io);
  static bool fits(const Event& event, const Seen& seen);
  bool waits_for_focus(const Event& event) const;
  void pass_event(const Event& event, ImGuiIO& io, Seen& seen);

  std::deque<Event> events_;
  ImVec2 place_ = {-FLT_MAX, -FLT_MAX};
  ImVec2 last_place_ = place_;  ///< place of the newest move, passed or not
  int frames_to_focus_ = 0;     ///< frames until what a click or shortcut opened takes keys
};

/// Maps the keys that edit text in ImGui, where no window does so.
void map_keys(ImGuiIO& io);

}  // namespace griffith::ui
