#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/recording/recording.h"
#include "sim/timeline/timeline.h"

namespace griffith::testing {

/// A wall that a ball strikes at once.
Scene struck_wall();

/// A scene of its own kind and how many steps of it say something.
struct RecordedScene {
  std::string name;
  Scene scene;
  int steps = 0;
};

/// Scenes that crack, are cut, fall asleep, splinter and are made of all kinds of files, which are written into the
/// folder.
std::vector<RecordedScene> recorded_scenes(const std::filesystem::path& folder);

/// What a user may do while it runs: a shot at step 4 and a weaker material at step 9. Goes back in between.
Timeline played(const Scene& scene, int steps);

/// Writes and reads it.
Recording through_file(const Recording& recording, const std::filesystem::path& folder);

}  // namespace griffith::testing
