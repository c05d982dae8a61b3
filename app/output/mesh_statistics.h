#pragma once

#include <string>
#include <vector>

#include "sim/meshing/mesh_quality.h"
#include "sim/meshing/mesh_surface.h"

namespace griffith::app {

/// Returns "tetgen" or "volumetric".
const char* method_name(MeshingMethod method);

/// Returns a JSON object about the surface, its filling and the shapes of the tets. Lengths in meters, angles in
/// degrees.
std::string mesh_statistics_json(const SurfaceMesh& mesh, const MeshQuality& quality);

/// Returns a JSON object about tets read from a file: findings and shapes.
std::string mesh_statistics_json(const std::vector<std::string>& findings, const MeshQuality& quality);

}  // namespace griffith::app
