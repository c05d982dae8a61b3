#include "ui/model/input_queue.h"

#include <algorithm>
#include <cfloat>

#include "ui/model/commands.h"

namespace griffith::ui {
namespace {

// Frames until the keyboard focus has arrived after a click or a shortcut, and has left after Enter, Escape or Tab.
constexpr int kFramesToFocus = 3, kFramesToLeave = 3;

bool is_modifier(int key) { return key >= key::kFirstModifier && key <= key::kLastModifier; }

/// True if the key writes a character unless modifiers make it a shortcut.
bool is_text_key(int key) { return key >= key::kSpace && key < key::kEscape; }

/// True if the key may be a shortcut that opens a field, such as the palette: a letter alone would be text there.
bool may_open_field(int key, const ImGuiIO& io) {
  return !io.WantTextInput && (io.KeyCtrl || io.KeyAlt || io.KeySuper || (key >= key::kF1 && key <= key::kF12));
}

bool either(const ImGuiIO& io, int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; }

}  // namespace

void InputQueue::key(int key, bool down) {
  if (key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown)) events_.push_back({Kind::key, key, down});
}

void InputQueue::button(int button, bool down) {
  if (button >= 0 && button < ImGuiMouseButton_COUNT) events_.push_back({Kind::button, button, down});
}

void InputQueue::move(ImVec2 place) {
  events_.push_back({.kind = Kind::move, .place = place});
  last_place_ = place;
}

void InputQueue::expect_at(ImVec2 place) {
  if (place.x != last_place_.x || place.y != last_place_.y) move(place);
}

void InputQueue::scroll(float right, float up) { events_.push_back({.kind = Kind::scroll, .place = {right, up}}); }

void InputQueue::text(unsigned int character) { events_.push_back({Kind::text, static_cast<int>(character)}); }

void InputQueue::end_frame() { events_.push_back({Kind::end_frame}); }

/// True if the event changes the state of `io`. Text comes without its keys: fields read the characters, and no
/// shortcut is triggered.
bool InputQueue::changes(const Event& event, const ImGuiIO& io) {
  if (event.kind == Kind::button) return io.MouseDown[event.code] != event.down;
  if (event.kind != Kind::key) return true;
  const bool typed = event.down && io.WantTextInput && is_text_key(event.code) && !io.KeyCtrl && !io.KeySuper;
  return !typed && io.KeysDown[event.code] != event.down;
}

bool InputQueue::fits(const Event& event, const Seen& seen) {
  const auto acted = [&](Kind kind) { return seen.act && seen.act->kind == kind; };
  switch (event.kind) {
    case Kind::key:
      return !seen.act && !seen.changed_keys[static_cast<std::size_t>(event.code)];
    case Kind::button:  // the mouse must have been seen there before its button changes
      return !seen.act && !seen.moved;
    case Kind::move:
      return !seen.act;
    case Kind::scroll:
      return !seen.act || acted(Kind::scroll);
    case Kind::text:
      return !seen.act || acted(Kind::text) || (acted(Kind::key) && is_text_key(seen.act->code));
    case Kind::end_frame:
      return false;
  }
  return true;
}

bool InputQueue::waits_for_focus(const Event& event) const {
  return frames_to_focus_ > 0 && (event.kind == Kind::text || (event.kind == Kind::key && event.down));
}

void InputQueue::pass_event(const Event& event, ImGuiIO& io, Seen& seen) {
  switch (event.kind) {
    case Kind::key:
      io.KeysDown[event.code] = event.down;
      seen.changed_keys[static_cast<std::size_t>(event.code)] = true;
      if (!event.down || is_modifier(event.code)) return;
      if (io.WantTextInput && !is_text_key(event.code)) frames_to_focus_ = kFramesToLeave;
      if (may_open_field(event.code, io)) frames_to_focus_ = kFramesToFocus;
      break;
    case Kind::button:
      io.MouseDown[event.code] = event.down;
      frames_to_focus_ = kFramesToFocus;  // a number opens when the button is released
      break;
    case Kind::move:
      place_ = event.place;
      seen.moved = true;
      return;
    case Kind::scroll:
      io.MouseWheelH += event.place.x;
      io.MouseWheel += event.place.y;
      break;
    case Kind::text:
      io.AddInputCharacter(static_cast<unsigned int>(event.code));
      break;
    case Kind::end_frame:
      return;
  }
  seen.act = event;
}

void InputQueue::play(ImGuiIO& io) {
  frames_to_focus_ = std::max(frames_to_focus_ - 1, 0);
  Seen seen;
  while (!events_.empty()) {
    const Event event = events_.front();
    if (event.kind == Kind::end_frame) {
      events_.pop_front();
      break;
    }
    if (changes(event, io)) {
      if (waits_for_focus(event) || !fits(event, seen)) break;
      pass_event(event, io, seen);
      io.KeyShift = either(io, key::kLeftShift, key::kRightShift);
      io.KeyCtrl = either(io, key::kLeftControl, key::kRightControl);
      io.KeyAlt = either(io, key::kLeftAlt, key::kRightAlt);
      io.KeySuper = either(io, key::kLeftSuper, key::kRightSuper);
    }
    events_.pop_front();
  }
  io.MousePos = place_;
}

void map_keys(ImGuiIO& io) {
  io.KeyMap[ImGuiKey_Tab] = key::kTab;
  io.KeyMap[ImGuiKey_Enter] = key::kEnter;
  io.KeyMap[ImGuiKey_Escape] = key::kEscape;
  io.KeyMap[ImGuiKey_Backspace] = key::kBackspace;
  io.KeyMap[ImGuiKey_Delete] = key::kDelete;
  io.KeyMap[ImGuiKey_LeftArrow] = key::kLeft;
  io.KeyMap[ImGuiKey_RightArrow] = key::kRight;
  io.KeyMap[ImGuiKey_UpArrow] = key::kUp;
  io.KeyMap[ImGuiKey_DownArrow] = key::kDown;
  io.KeyMap[ImGuiKey_Home] = key::kHome;
  io.KeyMap[ImGuiKey_End] = key::kEnd;
  io.KeyMap[ImGuiKey_A] = 'A';
}

}  // namespace griffith::ui
