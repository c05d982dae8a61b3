#pragma once

#include <span>
#include <string>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// What a report says of the run as a whole.
struct ReportHeading {
  std::string suite;           ///< its folder or name
  std::string renderer;        ///< GL_RENDERER
  std::string version;         ///< of the program
  std::string accept_command;  ///< makes all actual pictures golden ones; empty: none is offered
  double seconds = 0;          ///< that the run took
};

/// One page of HTML that needs no other file: what failed first, with golden and actual picture, their difference, the
/// two in one place (blinking, or beside a line that slides), the worst tile, whether the simulation or the drawing
/// changed, metadata and statistics side by side, changed lines of text and the command that accepts; then the others
/// as thumbnails. About 0.15 MB for each 320×180 picture that failed and 0.02 MB for one that passed.
std::string report_html(const ReportHeading& heading, std::span<const PictureResult> results);

}  // namespace griffith::app
