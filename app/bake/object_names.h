#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::app {

/// Returns distinct identifiers of letters, digits and _ for the scene's bodies and then for its projectiles: prefixes
/// of the names of objects and materials.
std::vector<std::string> name_stems(const Scene& scene);

/// Returns a numbered name: "pane_0012".
std::string numbered_name(const std::string& stem, int number);

}  // namespace griffith::app
