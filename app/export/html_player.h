#pragma once

#include <string>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns a page that plays a bake in a browser with WebGL 2: a single file without network access. Numbers have
/// single precision.
std::string html_player(const Bake& bake);

}  // namespace griffith::app
