#pragma once

#include <string>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// Returns the HTML of a command that a click copies.
std::string command_html(const std::string& command);

/// Returns the HTML about a picture that did not pass. `number`: of the picture in the report.
std::string report_article(const PictureResult& result, int number);

}  // namespace griffith::app
