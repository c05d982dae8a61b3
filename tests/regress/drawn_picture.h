#pragma once

#include <memory>
#include <vector>

#include "app/editor/imgui_context_owner.h"
#include "app/regress/picture_result.h"
#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "renderer/egl_context.h"
#include "renderer/renderer.h"
#include "sim/scene/scene.h"
#include "ui/widgets/labels.h"

namespace griffith::app {

/// All that a picture is drawn from, so that a test can spoil any of it.
struct Drawing {
  render::DrawScene scene;
  render::Camera camera;
  std::vector<ui::PictureLabel> labels;
  std::uint64_t state_hash = 0;
};

/// The tetrahedra of the small wall under fire after some steps, with numbers at the elements of a node.
Drawing drawing_of_wall(const std::string& view, const std::string& color_map = "viridis", double density_factor = 1);

/// Draws as the program does without a window.
class Drawer {
 public:
  static constexpr int kWidth = 320, kHeight = 180;

  Drawer() : interface_(kScale) {}

  RegressionPicture draw(const Drawing& drawing);

 private:
  static constexpr float kScale = 0.8f;  // of what is written in a picture of this size

  render::EglContext context_;
  render::Renderer renderer_;
  ImGuiContextOwner interface_;
};

}  // namespace griffith::app
