#pragma once

#include <optional>
#include <string>

#include "renderer/image.h"
#include "sim/recording/recording.h"

namespace griffith::app {

/// What a bug report holds beside the recorded run.
struct ReportParts {
  std::string log;                       ///< lines of what happened
  std::optional<render::Image> picture;  ///< of the last step, where there are graphics
};

/// Puts them into the recording as log.txt, below what it holds, and screenshot.png, with a README.txt that says how to
/// replay it.
void add_report(Recording& recording, const ReportParts& parts);

}  // namespace griffith::app
