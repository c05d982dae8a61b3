#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/shape.h"

namespace griffith {

/// The tets of a shape in the body's rest space [m], to be prepared (mesh_report.h). Relative paths start at `folder`.
/// A surface is filled, or recalled from the cache of meshes made before. `findings` gets what the user should know
/// about the file, a sentence each. Throws InputError when the mesh cannot be made or read, Cancelled when the monitor
/// says so.
TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder, std::vector<std::string>* findings = nullptr,
                  const Monitor& monitor = {});

}  // namespace griffith
