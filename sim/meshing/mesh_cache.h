#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/lattice_parting.h"
#include "sim/meshing/meshing_options.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Result of filling a surface.
struct FilledSurface {
  TetSoup soup;                                      ///< prepared
  MeshingMethod method = MeshingMethod::volumetric;  ///< method that made it
  std::string refusal;                               ///< reason why TetGen failed if it was tried; else empty
  std::string remedy;                                ///< possible remedy other than another surface; else empty
  LatticeParting parting;                            ///< result of the method volumetric
};

/// Returns $XDG_CACHE_HOME/griffith, or ~/.cache/griffith; empty if neither variable is set. The folder may be deleted
/// at any time.
std::filesystem::path default_mesh_cache();

/// Returns the file in `folder` for a surface and its options, named by a hash of both.
std::filesystem::path cache_entry(const std::filesystem::path& folder, const TriangleSurface& surface,
                                  const MeshingOptions& options);

/// Returns the content of an entry; none if the file is missing, of another kind or damaged.
std::optional<FilledSurface> read_cache_entry(const std::filesystem::path& path);

/// Writes an entry. Failure is not an error, since the mesh can be recomputed.
void write_cache_entry(const std::filesystem::path& path, const FilledSurface& filled);

}  // namespace griffith
