#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/shape.h"

namespace griffith {

/// Returns the tets of a shape in the body's rest space [m], to be prepared (mesh_report.h). Relative paths start at
/// `folder`. A surface is filled, or its mesh is taken from the cache. `findings` receives oddities of the file for the
/// user, a sentence each. Throws InputError if the mesh cannot be made or read, and Cancelled if the monitor requests
/// it.
TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder, std::vector<std::string>* findings = nullptr,
                  const Monitor& monitor = {});

}  // namespace griffith
