#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// A page that plays a bake in a browser with WebGL 2: one file, which asks for nothing from any network. Numbers are
/// of single precision.
std::string html_player(const Bake& bake);

}  // namespace griffith::app
