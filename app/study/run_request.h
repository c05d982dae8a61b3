#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study/run_record.h"
#include "sim/core/process.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// A run of a scene, as a process of its own: what happens to it happens to no other.
struct RunRequest {
  std::filesystem::path program;  ///< griffith
  std::filesystem::path scene;
  std::vector<SceneSetting> settings;
  int frames = 0;
};

/// The words `beginning`, then the scene and its settings.
std::vector<std::string> with_scene(std::vector<std::string> beginning, const RunRequest& request);
/// The arguments that make the run and write its record.
std::vector<std::string> simulate_words(const RunRequest& request, const std::filesystem::path& record);
/// The arguments that write a small picture of the run after `frame` steps.
std::vector<std::string> render_words(const RunRequest& request, int frame, const std::filesystem::path& picture);
/// The arguments that open the run in the editor.
std::vector<std::string> editor_words(const RunRequest& request);

/// Makes the run and leaves its record, or the record of why it failed. A run that is killed is made again, twice.
/// Returns whether there is a record: false when it was cancelled. Throws InputError when the record cannot be written.
bool make_run(const RunRequest& request, const std::filesystem::path& record, const ProcessLimits& limits,
              const std::function<bool()>& cancelled);

}  // namespace griffith::app
