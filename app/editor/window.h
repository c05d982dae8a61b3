#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// Options of the editor's window.
struct EditorOptions {
  std::filesystem::path scene;         ///< empty: the default scene
  std::vector<SceneSetting> settings;  ///< replace values of the file
  std::filesystem::path script;        ///< script to play, if not empty
  int exit_after = 0;                  ///< number of pictures after which the program ends; 0: never
  std::filesystem::path screenshot;    ///< written at that end, if not empty
};

/// Opens the window and returns when it is closed. Throws std::runtime_error if there is no display.
void run_editor(const EditorOptions& options);

}  // namespace griffith::app
