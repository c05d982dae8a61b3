#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/world/setup/element_choice.h"

namespace griffith {

/// Throws an InputError where quadratic elements or residual stress meet what they cannot do.
void check_elements(const Scene& scene, int scene_body, ElementOrder order, const Material& material);

/// Returns the element order of a scene body with this mesh. ElementOrder::automatic becomes quadratic in a
/// slender body (slenderness() of 8 or more) with fewer than four elements across its thinnest part: there, linear ones
/// are too stiff in bending. Bodies of soft materials stay linear, as quadratic elements invert sooner under large
/// strain, and so do those with features that quadratic elements do not support.
ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh);

}  // namespace griffith
