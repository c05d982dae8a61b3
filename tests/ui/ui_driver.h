#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "app/editor/editor_commands.h"
#include "ui/model/gestures.h"
#include "ui/panels/editor_layout.h"

namespace griffith::ui {

/// Drives the editor's panels in process: an ImGui context without graphics, a mouse and a keyboard.
class UiDriver {
 public:
  explicit UiDriver(Scene scene);
  ~UiDriver();
  UiDriver(const UiDriver&) = delete;
  UiDriver& operator=(const UiDriver&) = delete;

  /// Draws a frame; what it asks for is appended to commands.
  void frame();
  /// Where the middle of a widget is. Fails the test when there is none of that tag.
  ImVec2 find(const std::string& tag);
  /// Returns the value that a widget shows.
  std::string value(const std::string& tag);

  void move(ImVec2 place);
  void press(int button, bool down);
  /// Presses and releases over a widget.
  void click(const std::string& tag, int button = 0);
  /// Presses over the widget and releases `dx` pixels to the right and `dy` down, in many small moves.
  void drag(const std::string& tag, float dx, float dy = 0, int button = 0);
  /// Types text into what has the focus, then Enter.
  void type(const std::string& text);
  void press_key(int key, bool ctrl = false, bool shift = false, bool alt = false);
  /// Returns the commands issued so far.
  std::vector<std::string_view> issued() const;
  /// Returns the context that enables or disables commands.
  CommandContext context() const {
    return {state, history, input.time, input.frame.step, input.views[0].legend.has_value()};
  }

  EditorInput input;
  EditorState state;
  EditHistory history;
  WidgetTags tags;
  std::vector<Command> commands;
  InputQueue queue;  ///< events of mouse and keyboard

 private:
  /// Draws the frames that what was done takes.
  void play();

  std::vector<Material> materials_;
};

/// A scene with two bodies.
Scene two_walls();
Probe probe_of(const std::string& body, const std::string& name);

}  // namespace griffith::ui
