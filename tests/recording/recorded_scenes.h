#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/recording/recording.h"
#include "sim/timeline/timeline.h"

namespace griffith::testing {

/// Returns a wall that a ball hits at once.
Scene struck_wall();

/// Scene with a number of steps that is representative.
struct RecordedScene {
  std::string name;
  Scene scene;
  int steps = 0;
};

/// Returns scenes that crack, are remeshed, fall asleep, splinter and are made of all kinds of files, which are written
/// into the folder.
std::vector<RecordedScene> recorded_scenes(const std::filesystem::path& folder);

/// Plays a run with inputs: a shot at step 4 and a weaker material at step 9. Goes back in between.
Timeline played(const Scene& scene, int steps);

/// Writes and reads a recording.
Recording through_file(const Recording& recording, const std::filesystem::path& folder);

}  // namespace griffith::testing
