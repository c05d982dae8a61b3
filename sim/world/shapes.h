#pragma once

#include <filesystem>

#include "sim/mesh/tet_mesh.h"
#include "sim/scene/shape.h"

namespace griffith {

/// The tets of a shape in the body's rest space [m], to be prepared (mesh_report.h). Relative mesh paths start at
/// `folder`. Throws InputError when the mesh cannot be made or read.
TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder);

}  // namespace griffith
