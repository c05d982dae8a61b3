#pragma once

#include <optional>
#include <string>

#include "renderer/image.h"
#include "sim/recording/recording.h"

namespace griffith::app {

/// Parts of a bug report besides the recorded run.
struct ReportParts {
  std::string log;                       ///< messages
  std::optional<render::Image> picture;  ///< picture of the last step, if graphics are available
};

/// Adds the parts to the recording as log.txt, after its present content, and screenshot.png, with a README.txt about
/// replaying it.
void add_report(Recording& recording, const ReportParts& parts);

}  // namespace griffith::app
