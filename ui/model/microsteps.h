#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Playback of the recorded microsteps of a step.
struct MicrostepPlayback {
  double place = 0;  ///< place among the recorded moments, between the shown one and the next while playing
  bool playing = false;
  int moment() const { return static_cast<int>(place); }
};

/// The recorded microsteps of a step, as the panels show them.
struct MicrostepView {
  struct Moment {
    std::int64_t microstep = 0;  ///< number in the step, from 1
    double time = 0;             ///< since the beginning of the step [s]
    int cracks = 0;              ///< in the step up to this moment
  };
  std::int64_t step = 0;        ///< step that they belong to
  std::int64_t microsteps = 0;  ///< number of microsteps of the step
  std::int64_t interval = 1;    ///< number of microsteps from one moment to the next
  std::vector<Moment> moments;
  std::size_t memory = 0, memory_limit = 0;  ///< [bytes]

  /// True if the moments span only a part of the step's microsteps.
  bool is_part() const {
    return !moments.empty() && (moments.front().microstep > 1 || moments.back().microstep + interval <= microsteps);
  }
};

/// Returns the number of microsteps of the last step; with explicit integration that of its substeps.
int microsteps_of(const Frame& frame, const Scene& scene);

/// Describes the time of a moment since the first one: "+126.42 µs".
std::string moment_text(const MicrostepView& view, int moment);
/// Describes a moment among all microsteps: "microstep 65 of 6,873 in step 2".
std::string microstep_text(const MicrostepView& view, int moment);
/// Describes the size of the recording: "92 moments, every 64 microsteps, 330 of 512 MB".
std::string recording_text(const MicrostepView& view);

}  // namespace griffith::ui
