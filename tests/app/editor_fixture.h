#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <string>
#include <thread>

#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/imgui_context_owner.h"
#include "app/editor/messages.h"
#include "app/editor/picking.h"
#include "program.h"
#include "renderer/egl_context.h"
#include "renderer/target.h"
#include "ui/model/gestures.h"

namespace griffith::app {

/// The editor with graphics but without a window, driven through its widgets.
class EditorTest : public ::testing::Test {
 protected:
  explicit EditorTest(const Scene& scene = small_wall(), int width = 1200)
      : imgui_(1), target_(width, 1060), editor_(scene, "") {
    editor_.viewport().limit_quality(PictureQuality::draft);  // a software renderer takes ten times as long for others
    draw(3);
  }

  void draw(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      editor_.draw_picture(1);
      imgui_.begin_frame(target_.width(), target_.height());
      editor_.draw_panels(imgui_.fonts());
      ImGui::Render();
    }
  }

  /// Returns the window as the last frame left it. Panels are painted here alone: by a software renderer they take most
  /// of a frame's time.
  render::Image window_image() {
    target_.bind();
    imgui_.end_frame();
    return target_.image();
  }

  void click(const std::string& tag, int button = 0) {
    const ui::WidgetTag* widget = ui::find_tag(editor_.tags(), tag);
    ASSERT_NE(widget, nullptr) << tag;
    ui::click(queue_, widget->center(), button);
    play();
    draw();
  }

  /// Draws the frames that what was done takes.
  void play() {
    while (!queue_.empty()) {
      queue_.play(ImGui::GetIO());
      draw();
    }
  }

  /// Draws until nothing is being built and nothing waits for that, a minute at most.
  void wait_for_work() {
    for (int i = 0; i < 6000 && is_working(); ++i) draw_while_working();
    draw(4);  // a dialog needs some to find its place
  }

  bool is_working() const { return !editor_.state().work.empty() || !editor_.state().waiting.empty(); }

  /// Draws the next frame; leaves the processor to work that goes on in the background.
  void draw_while_working() {
    if (is_working()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    draw();
  }

  /// Answers the question whether so large a mesh is meant.
  void insist() {
    wait_for_work();
    click("large_mesh/build");
    draw(3);
  }

  std::string value(const std::string& tag) const {
    const ui::WidgetTag* widget = ui::find_tag(editor_.tags(), tag);
    return widget ? widget->value : "no widget " + tag;
  }

  void press_key(int key, bool ctrl = false, bool shift = false, bool alt = false) {
    ui::press(queue_, {key, ctrl, shift, alt});
    play();
    draw();
  }

  /// Types into what has the focus.
  void type(const std::string& text) {
    ui::type(queue_, text);
    play();
    draw();
  }

  /// Returns the number of 100 places from the left to the right end of the picture's middle row that show a body.
  int hits_across() {
    int hits = 0;
    for (int i = 0; i < 100; ++i) {
      editor_.execute({.name = "view.pick", .cursor = Vec2((i + 0.5) / 100, 0.5)});
      hits += editor_.state().selection.valid();
    }
    return hits;
  }

  void choose_material(const std::string& preset) {
    click("material/preset");
    click("material/preset/" + preset);
  }

  render::EglContext context_;
  ImGuiContextOwner imgui_;
  render::Target target_;
  Editor editor_;
  ui::InputQueue queue_;
};

}  // namespace griffith::app
