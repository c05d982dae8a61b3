#pragma once

#include <span>
#include <string>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// Description of the whole run for the report.
struct ReportHeading {
  std::string suite;           ///< folder or name of the suite
  std::string renderer;        ///< GL_RENDERER
  std::string version;         ///< version of the program
  std::string accept_command;  ///< accepts all actual pictures as golden; empty: not offered
  double seconds = 0;          ///< duration of the run
};

/// Returns one HTML page that needs no other file. Failures come first, with golden and actual picture, their
/// difference, an overlay of both (blinking or with a slider), the worst tile, whether the simulation or the drawing
/// changed, metadata and statistics side by side, changed lines of text and the command that accepts; the others follow
/// as thumbnails. About 0.15 MB for each failed 320×180 picture and 0.02 MB for each that passed.
std::string report_html(const ReportHeading& heading, std::span<const PictureResult> results);

}  // namespace griffith::app
