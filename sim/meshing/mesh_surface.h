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

/// How meshing runs: nothing here changes the mesh.
struct MeshingSetup {
  std::string name = "surface";                         ///< begins messages: a file
  ProcessLimits limits = {300, std::int64_t{8} << 30};  ///< of TetGen
  std::filesystem::path cache;                          ///< folder of meshes made before; empty: none
  Monitor monitor;
};

/// A surface filled with tets.
struct SurfaceMesh {
  TetSoup soup;             ///< prepared (mesh_report.h)
  TriangleSurface surface;  ///< the surface as it was repaired, to be shown in place of the tets' own
  SurfaceReport surface_report;
  MeshingMethod method = MeshingMethod::volumetric;  ///< that made the tets
  bool from_cache = false;
  std::vector<std::string> findings;  ///< what the user should know, a sentence each
};

/// Fills a surface with tets. Throws InputError when there is no inside, when the wanted method cannot do it, or when a
/// limit is reached; Cancelled when the monitor says so.
SurfaceMesh mesh_surface(TriangleSurface surface, const MeshingOptions& options, const MeshingSetup& setup = {});

/// The element size of the options, or the one that they leave to the surface [m].
double element_size_for(const SurfaceReport& report, const MeshingOptions& options);

}  // namespace griffith
