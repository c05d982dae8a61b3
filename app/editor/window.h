#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// The editor in a window.
struct EditorOptions {
  std::filesystem::path scene;         ///< empty: a scene to start with
  std::vector<SceneSetting> settings;  ///< in place of what its file says
  std::filesystem::path script;        ///< played in it, if not empty
  int exit_after = 0;                  ///< pictures after which the program ends by itself; 0: never
  std::filesystem::path screenshot;    ///< written at that end, if not empty
};

/// Opens the window and returns when it is closed. Throws std::runtime_error when there is no display.
void run_editor(const EditorOptions& options);

}  // namespace griffith::app
