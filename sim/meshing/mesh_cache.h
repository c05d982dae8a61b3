#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/lattice_parting.h"
#include "sim/meshing/meshing_options.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// What filling a surface gave.
struct FilledSurface {
  TetSoup soup;                                      ///< prepared
  MeshingMethod method = MeshingMethod::volumetric;  ///< that made it
  std::string refusal;                               ///< why TetGen did not, where it was meant to; else empty
  std::string remedy;                                ///< what might help it besides another surface; else empty
  LatticeParting parting;                            ///< of the method volumetric
};

/// $XDG_CACHE_HOME/griffith, or ~/.cache/griffith; empty when neither variable is set. It may be deleted at any time.
std::filesystem::path default_mesh_cache();

/// The file in `folder` for a surface and its options, named by a hash of both.
std::filesystem::path cache_entry(const std::filesystem::path& folder, const TriangleSurface& surface,
                                  const MeshingOptions& options);

/// What write_cache_entry() wrote; nothing where there is no file, or another or damaged content.
std::optional<FilledSurface> read_cache_entry(const std::filesystem::path& path);

/// Failing to write is no error: the mesh will be made again.
void write_cache_entry(const std::filesystem::path& path, const FilledSurface& filled);

}  // namespace griffith
