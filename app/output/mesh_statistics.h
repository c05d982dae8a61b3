#pragma once

#include <string>
#include <vector>

#include "sim/meshing/mesh_quality.h"
#include "sim/meshing/mesh_surface.h"

namespace griffith::app {

/// "tetgen" or "volumetric".
const char* method_name(MeshingMethod method);

/// A JSON object of what was found in the surface, how it was filled and the shapes of the tets. Lengths in metres,
/// angles in degrees.
std::string mesh_statistics_json(const SurfaceMesh& mesh, const MeshQuality& quality);

/// The same of tets that were read as such: what was found in them, and their shapes.
std::string mesh_statistics_json(const std::vector<std::string>& findings, const MeshQuality& quality);

}  // namespace griffith::app
