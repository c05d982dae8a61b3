#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// The things and bonds of a bake as JSON, without surfaces and motion; SI units. Break times are null where there are
/// none.
std::string bake_json(const Bake& bake);

}  // namespace griffith::app
