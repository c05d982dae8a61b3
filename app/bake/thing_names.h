#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::app {

/// Words of letters, digits and _ for the scene's bodies and then for its projectiles, each another one: what names of
/// things and materials begin with.
std::vector<std::string> name_stems(const Scene& scene);

/// "pane_0012"
std::string numbered_name(const std::string& stem, int number);

}  // namespace griffith::app
