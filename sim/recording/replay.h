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

/// Where a run first differs from its recording.
struct ReplayDifference {
  std::int64_t step = 0;                 ///< 0: the start already
  std::vector<std::string_view> fields;  ///< of kStateFields
};

/// Makes a recorded run again, from the recording alone.
class Replay {
 public:
  /// Unpacks the recording's files and builds the world. The recording must live as long as this. Throws InputError
  /// where a file cannot be used, Cancelled when the monitor says so or the program is asked to end.
  explicit Replay(const Recording& recording, const Monitor& monitor = {});

  const World& world() const { return world_; }
  /// The recording's, with its files where they are unpacked.
  const Scene& scene() const { return scene_; }
  bool at_end() const { return world_.frame().step >= recording_.steps(); }
  /// Makes the next step, which there must be, and does what was done after it. Throws InputError for an input that the
  /// world refuses, Cancelled when the program is asked to end: so it leaves no files behind.
  void advance();
  /// The first step so far that differs; nothing where all are equal.
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
