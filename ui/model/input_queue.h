#pragma once

#include <imgui.h>

#include <array>
#include <deque>
#include <optional>

namespace griffith::ui {

/// The window's events on their way to ImGui, in their order. ImGui reads the state of keys and buttons once a frame:
/// where frames take long, a tap begins and ends within one and would go unseen, and a key would meet modifiers that it
/// was not pressed with. So each frame gets the next events up to the first that would hide an earlier one of them.
class InputQueue {
 public:
  /// A key of GLFW's numbering went down or up; others than 0..511 are ignored.
  void key(int key, bool down);
  /// A mouse button, 0..4.
  void button(int button, bool down);
  void move(ImVec2 place);
  void scroll(float right, float up);
  void text(unsigned int character);

  /// What comes behind is for a later frame.
  void end_frame();

  /// Tells `io` what the next frame is to see. To be called once a frame, before ImGui::NewFrame().
  void play(ImGuiIO& io);
  bool empty() const { return events_.empty(); }

 private:
  enum class Kind { key, button, move, scroll, text, end_frame };
  struct Event {
    Kind kind;
    int code = 0;  ///< of the key or button, or the character
    bool down = false;
    ImVec2 place = {};  ///< or how far the wheel turned
  };
  /// What the frame that is being put together has seen so far.
  struct Seen {
    std::optional<Event> act;  ///< a press, a button, the wheel or text
    bool moved = false;
    std::array<bool, IM_ARRAYSIZE(ImGuiIO::KeysDown)> changed_keys = {};
  };

  static bool changes(const Event& event, const ImGuiIO& io);
  static bool fits(const Event& event, const Seen& seen);
  bool waits_for_focus(const Event& event) const;
  void tell(const Event& event, ImGuiIO& io, Seen& seen);

  std::deque<Event> events_;
  ImVec2 place_ = {-FLT_MAX, -FLT_MAX};
  int frames_to_focus_ = 0;  ///< until what a click opened takes keys
};

/// Tells ImGui which keys move the cursor in texts and leave them, where no window does.
void map_keys(ImGuiIO& io);

}  // namespace griffith::ui
