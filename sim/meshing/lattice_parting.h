#pragma once

#include <cstdint>
#include <string>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/mesh_surface.h"

namespace griffith {

/// Pieces of a solid that is thinner than the lattice's elements in places, and the element size that keeps it
/// connected.
struct LatticeParting {
  std::int32_t pieces = 1;  ///< pieces of the mesh
  std::int32_t joined = 1;  ///< pieces of the best finer mesh that was tried; `pieces` if none has fewer
  std::int32_t shells = 1;  ///< shells of the surface
  std::int32_t tried = 0;   ///< number of finer meshes that were tried
  double element_size = 0;  ///< element size of the best of them [m]; 0: none has fewer pieces
  double least_size = 0;    ///< smallest element size of them [m]
};

/// Counts the pieces of a mesh from stuff_surface(). If the lattice may have caused them, tries finer ones down to an
/// eighth of `element_size`, with at most half a million tets. `mesh`: prepared. Throws Cancelled.
LatticeParting find_parting(const TriangleSurface& surface, const SurfaceReport& report, const TetSoup& mesh,
                            const MeshingOptions& options, double element_size, const MeshingSetup& setup);

/// Returns a sentence on the pieces and the remedy; empty if there is nothing to report.
std::string finding(const LatticeParting& parting);

}  // namespace griffith
