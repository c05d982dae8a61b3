#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/camera.h"
#include "sim/scene/scene.h"
#include "ui/model/commands.h"

namespace griffith::app {

/// State of the editor that a macro records in addition to commands.
struct MacroMoment {
  Scene scene;  ///< with the current view
  ProjectileBurst shot;
  std::vector<std::string> chosen;  ///< full names of entries
  std::int64_t step = 0;
  render::Camera camera;
};

/// Returns a scene with the shot of the projectile tool, by whose fields scripts name its own.
Scene scene_of_shot(const ProjectileBurst& shot);

/// Writes a script of the user's actions: the commands, and between them all other changes. The input of dialogs is in
/// the commands that follow; running becomes steps.
class MacroRecorder {
 public:
  explicit MacroRecorder(MacroMoment start) : last_(std::move(start)) {}

  /// Records changes other than steps and camera, which precede the next line.
  void note(const MacroMoment& now);
  /// Marks the current state as the result of a command.
  void skip(MacroMoment now) { last_ = std::move(now); }
  /// Records an executed command; `now` is its result.
  void add(const ui::Command& command, MacroMoment now);

  /// Returns the script. `end`: state at the end of the recording.
  std::string text(const MacroMoment& end);

 private:
  void add_line(std::string line);
  void add_waiting();

  MacroMoment last_;
  std::vector<std::string> lines_;
  std::int64_t waiting_steps_ = 0;
  bool camera_moved_ = false;
};

}  // namespace griffith::app
