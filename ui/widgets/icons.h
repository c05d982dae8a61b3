#pragma once

#include <imgui.h>

namespace griffith::ui {

enum class Icon {
  none,
  play,
  pause,
  step,
  step_back,
  to_start,
  to_end,
  reset,
  fire,
  grab,
  push,
  open,
  camera,
  frame,
  help,
  undo,
  redo,
  body,
  support,
  load,
  projectile,
  probe,
  eye,
  closed_eye
};

/// Draws an icon into a square of `size` pixels around `center`.
void draw_icon(ImDrawList* list, Icon icon, ImVec2 center, float size, ImU32 color);

}  // namespace griffith::ui
