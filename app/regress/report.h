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

/// Returns the results as JUnit XML for continuous integration: a test case for each picture with its time [s]. A
/// picture that failed, or that has no golden one, is a failure; one that could not be drawn is an error.
std::string junit_xml(const std::string& suite, std::span<const PictureResult> results);

/// Returns the HTML of a command that a click copies.
std::string command_html(const std::string& command);

/// Returns the HTML about a picture that did not pass. `number`: of the picture in the report.
std::string report_article(const PictureResult& result, int number);

}  // namespace griffith::app
