#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study/run_record.h"
#include "sim/core/process.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// A run of a scene in a process of its own, so that a crash affects no other.
struct RunRequest {
  std::filesystem::path program;  ///< path of griffith
  std::filesystem::path scene;
  std::vector<SceneSetting> settings;
  int frames = 0;
};

/// Returns the words `beginning`, followed by the scene and its settings.
std::vector<std::string> with_scene(std::vector<std::string> beginning, const RunRequest& request);
/// Returns the arguments that make the run and write its record.
std::vector<std::string> simulate_words(const RunRequest& request, const std::filesystem::path& record);
/// Returns the arguments that write a small picture of the run after `frame` steps.
std::vector<std::string> render_words(const RunRequest& request, int frame, const std::filesystem::path& picture);
/// Returns the arguments that open the run in the editor.
std::vector<std::string> editor_words(const RunRequest& request);

/// Makes the run and writes its record, or the record of its failure. A run that is killed is repeated twice. Returns
/// true if there is a record, false if it was cancelled. Throws InputError if the record cannot be written.
bool make_run(const RunRequest& request, const std::filesystem::path& record, const ProcessLimits& limits,
              const std::function<bool()>& cancelled);

}  // namespace griffith::app
