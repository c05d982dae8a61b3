#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/core/temporary_folder.h"
#include "sim/recording/recording.h"
#include "sim/world/world.h"

namespace griffith {

/// First difference of a run from its recording.
struct ReplayDifference {
  std::int64_t step = 0;                 ///< 0: the start
  std::vector<std::string_view> fields;  ///< different fields of kStateFields
};

/// Repeats a recorded run from the recording alone.
class Replay {
 public:
  /// Unpacks the recording's files and builds the world. The recording must outlive this object. Throws InputError if a
  /// file cannot be used, Cancelled if the monitor cancels or the program is asked to end.
  explicit Replay(const Recording& recording, const Monitor& monitor = {});

  const World& world() const { return world_; }
  /// Scene of the recording, with paths to the unpacked files.
  const Scene& scene() const { return scene_; }
  bool at_end() const { return world_.frame().step >= recording_.steps(); }
  /// Computes the next step, which must exist, and applies the inputs after it. Throws InputError for an input that the
  /// world refuses. Throws Cancelled if the program is asked to end, so that no files are left behind.
  void advance();
  /// First step so far that differs, if any.
  const std::optional<ReplayDifference>& difference() const { return difference_; }

 private:
  void compare();
  void do_inputs();

  const Recording& recording_;
  TemporaryFolder folder_;
  Scene scene_;
  World world_;
  std::size_t inputs_done_ = 0;
  std::optional<ReplayDifference> difference_;
};

}  // namespace griffith
