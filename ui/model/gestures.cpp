#include "ui/model/gestures.h"

#include <imgui_internal.h>

namespace griffith::ui {
namespace {

constexpr int kMovesOfDrag = 20;

void press_modifiers(InputQueue& queue, const Shortcut& shortcut, bool down) {
  if (shortcut.ctrl) queue.key(key::kLeftControl, down);
  if (shortcut.alt) queue.key(key::kLeftAlt, down);
  if (shortcut.shift) queue.key(key::kLeftShift, down);
}

}  // namespace

void click(InputQueue& queue, ImVec2 place, int button) {
  queue.move(place);
  queue.end_frame();  // an item learns only a frame later that the mouse is over it
  queue.button(button, true);
  queue.button(button, false);
}

void drag(InputQueue& queue, ImVec2 start, ImVec2 way, int button) {
  queue.move(start);
  queue.end_frame();
  queue.button(button, true);
  for (int i = 1; i <= kMovesOfDrag; ++i) {
    const float part = static_cast<float>(i) / kMovesOfDrag;
    queue.end_frame();
    queue.move({start.x + part * way.x, start.y + part * way.y});
  }
  queue.end_frame();
  queue.button(button, false);
}

void scroll(InputQueue& queue, ImVec2 place, float notches) {
  queue.move(place);
  queue.end_frame();
  queue.scroll(0, -notches);
}

void type(InputQueue& queue, std::string_view text) {
  const char* place = text.data();
  const char* const end = place + text.size();
  while (place < end) {
    unsigned int character = 0;
    place += ImTextCharFromUtf8(&character, place, end);
    queue.text(character);
  }
}

void press(InputQueue& queue, const Shortcut& shortcut) {
  press_modifiers(queue, shortcut, true);
  queue.key(shortcut.key, true);
  queue.key(shortcut.key, false);
  press_modifiers(queue, shortcut, false);
}

}  // namespace griffith::ui
