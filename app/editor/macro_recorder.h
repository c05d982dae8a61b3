#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/camera.h"
#include "sim/scene/scene.h"
#include "ui/model/commands.h"

namespace griffith::app {

/// What of the editor a macro tells apart from commands.
struct MacroMoment {
  Scene scene;  ///< with the view as it is shown
  ProjectileBurst shot;
  std::vector<std::string> chosen;  ///< full names of entries
  std::int64_t step = 0;
  render::Camera camera;
};

/// The projectile tool's shot as the one of a scene, by whose fields scripts name its own.
Scene scene_of_shot(const ProjectileBurst& shot);

/// Writes a script of what is done in the editor: the commands, and between them what else has changed. What a dialog
/// asks for is in the commands that carry it out; time that passes becomes steps.
class MacroRecorder {
 public:
  explicit MacroRecorder(MacroMoment start) : last_(std::move(start)) {}

  /// Writes down what has changed, but for steps and camera, which stand before the next line.
  void note(const MacroMoment& now);
  /// What is there now came from a command.
  void skip(MacroMoment now) { last_ = std::move(now); }
  /// Writes down a command that was carried out; what it did is in `now`.
  void add(const ui::Command& command, MacroMoment now);

  /// The script. `end`: of what is recorded.
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
