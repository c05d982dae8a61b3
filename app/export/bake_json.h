#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns the objects and bonds of a bake as JSON, without surfaces and motion; SI units. Missing break times are
/// null.
std::string bake_json(const Bake& bake);

}  // namespace griffith::app
