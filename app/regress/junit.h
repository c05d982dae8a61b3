#pragma once

#include <span>
#include <string>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// Returns the results as JUnit XML for continuous integration: a test case for each picture with its time [s]. A
/// picture that failed, or that has no golden one, is a failure; one that could not be drawn is an error.
std::string junit_xml(const std::string& suite, std::span<const PictureResult> results);

}  // namespace griffith::app
