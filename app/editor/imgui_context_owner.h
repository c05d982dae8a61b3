#pragma once

#include <imgui.h>

#include "ui/widgets/fonts.h"

struct ImGuiContext;

namespace griffith::app {

/// Owner of the ImGui context, drawn with OpenGL. Construct and use it while an OpenGL 3.3 context is current, one at a
/// time. Reads and writes no settings file.
class ImGuiContextOwner {
 public:
  /// `scale`: screen pixels per design pixel.
  explicit ImGuiContextOwner(float scale);
  ~ImGuiContextOwner();
  ImGuiContextOwner(const ImGuiContextOwner&) = delete;
  ImGuiContextOwner& operator=(const ImGuiContextOwner&) = delete;

  const ui::Fonts& fonts() const { return fonts_; }

  /// Changes the size of everything, between two frames. True if it was different.
  bool set_scale(float scale);

  /// Begins a frame of that size without a window or input, a fixed time after the last.
  void begin_frame(int width, int height);
  /// Begins a frame whose size and input were set elsewhere.
  void begin_frame();
  /// Ends the frame and draws it into the bound framebuffer.
  void end_frame();
  /// Draws a part of it alone, into a target of its size [pixels].
  void end_frame(ImVec2 corner, ImVec2 size);

 private:
  ImGuiContext* context_;
  ui::Fonts fonts_;
  float scale_;
};

}  // namespace griffith::app
