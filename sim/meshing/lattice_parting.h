#pragma once

#include <cstdint>
#include <string>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/mesh_surface.h"

namespace griffith {

/// Pieces that a lattice has parted a solid into where it is thinner than the elements, and the element size that keeps
/// it together.
struct LatticeParting {
  std::int32_t pieces = 1;  ///< of the mesh
  std::int32_t joined = 1;  ///< of the best finer mesh that was tried; as many as `pieces` where none has fewer
  std::int32_t shells = 1;  ///< of the surface
  std::int32_t tried = 0;   ///< finer meshes that were tried
  double element_size = 0;  ///< of the best of them [m]; 0: none has fewer pieces
  double least_size = 0;    ///< smallest element size of them [m]
};

/// Counts the pieces of a mesh from stuff_surface(). Where they may come from the lattice, finer ones are tried down to
/// an eighth of `element_size`, as long as they have no more than half a million tets. `mesh`: prepared. Throws
/// Cancelled.
LatticeParting find_parting(const TriangleSurface& surface, const SurfaceReport& report, const TetSoup& mesh,
                            const MeshingOptions& options, double element_size, const MeshingSetup& setup);

/// A sentence on the parting and its remedy; empty where there is nothing to tell.
std::string finding(const LatticeParting& parting);

}  // namespace griffith
