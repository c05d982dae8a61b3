#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/world/element_choice.h"

namespace griffith {

/// Throws an InputError where quadratic elements or residual stress meet what they cannot do.
void check_elements(const Scene& scene, int scene_body, ElementOrder order, const Material& material);

/// The elements of a scene body with this mesh. ElementOrder::automatic is quadratic where fewer than four linear ones
/// lie across the thinnest part of the body, which then hardly bend, and nothing speaks against it.
ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh);

}  // namespace griffith
