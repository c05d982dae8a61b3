#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/world/setup/element_choice.h"

namespace griffith {

/// Throws an InputError where quadratic elements or residual stress meet what they cannot do.
void check_elements(const Scene& scene, int scene_body, ElementOrder order, const Material& material);

/// Returns the element order of a scene body with this mesh. ElementOrder::automatic becomes quadratic if there are
/// fewer than four linear elements across the thinnest part of the body, which then are too stiff in bending, and no
/// feature prevents it.
ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh);

}  // namespace griffith
