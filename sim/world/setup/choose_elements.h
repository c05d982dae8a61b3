#pragma once

#include "sim/mesh/tet_mesh.h"
#include "sim/world/setup/element_choice.h"

namespace griffith {

/// Returns the element order of a scene body with this mesh. ElementOrder::automatic becomes quadratic in a
/// slender body (slenderness() of 8 or more) with fewer than four elements across its thinnest part: there, linear ones
/// are too stiff in bending. Bodies of soft materials stay linear, as quadratic elements invert sooner under large
/// strain.
ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh);

}  // namespace griffith
