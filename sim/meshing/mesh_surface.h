#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/monitor.h"
#include "sim/core/process.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/meshing_options.h"
#include "sim/meshing/surface.h"
#include "sim/meshing/surface_report.h"

namespace griffith {

/// Settings of meshing that do not affect the mesh.
struct MeshingSetup {
  std::string name = "surface";                         ///< beginning of messages: a file
  ProcessLimits limits = {300, std::int64_t{8} << 30};  ///< limits of TetGen
  std::filesystem::path cache;                          ///< folder of earlier meshes; empty: none
  Monitor monitor;
};

/// Surface filled with tets.
struct SurfaceMesh {
  TetSoup soup;             ///< prepared (mesh_report.h)
  TriangleSurface surface;  ///< the repaired surface, shown in place of the tets' own
  SurfaceReport surface_report;
  MeshingMethod method = MeshingMethod::volumetric;  ///< method that made the tets
  bool from_cache = false;
  std::vector<std::string> findings;  ///< sentences for the user
};

/// Fills a surface with tets. Throws InputError if there is no interior, if the requested method fails, or if a limit
/// is reached. Throws Cancelled when the monitor cancels.
SurfaceMesh mesh_surface(TriangleSurface surface, const MeshingOptions& options, const MeshingSetup& setup = {});

/// Returns the element size of the options, or its default for the surface [m].
double element_size_for(const SurfaceReport& report, const MeshingOptions& options);

}  // namespace griffith
