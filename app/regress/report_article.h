#pragma once

#include <string>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// A command that a click copies, as HTML.
std::string command_html(const std::string& command);

/// What the report says of a picture that did not pass, as HTML. `number`: of the picture in the report.
std::string report_article(const PictureResult& result, int number);

}  // namespace griffith::app
