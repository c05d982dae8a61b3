#pragma once

#include <string_view>

#include "ui/model/input_queue.h"
#include "ui/model/shortcut.h"

namespace griffith::ui {

// Gestures of mouse and keyboard as events of a queue, with which scripts and tests drive the panels.

/// Presses and releases a mouse button.
void click(InputQueue& queue, ImVec2 place, int button = 0);
/// Presses a mouse button, moves the mouse by `way` [pixels] over several frames and releases it.
void drag(InputQueue& queue, ImVec2 start, ImVec2 way, int button = 0);
/// Turns the wheel over a place; `notches` > 0 scrolls toward the end.
void scroll(InputQueue& queue, ImVec2 place, float notches);
/// Types UTF-8 text into the focused item.
void type(InputQueue& queue, std::string_view text);
/// Presses a key with its modifiers and releases them.
void press(InputQueue& queue, const Shortcut& shortcut);

}  // namespace griffith::ui
