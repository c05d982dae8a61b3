#pragma once

#include <string>

#include "sim/core/monitor.h"
#include "sim/core/process.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/meshing_options.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Result of TetGen.
struct TetgenResult {
  TetSoup soup;
  std::string refusal;  ///< reason of failure; empty after success
  std::string remedy;   ///< possible remedy other than another surface, such as more time; else empty
};

/// Fills a surface with tets by running TetGen (Si 2015) as a separate program in a temporary folder. Faces on the
/// surface get edges of about `element_size` [m], or smaller ones where the surface's own triangles are smaller. Throws
/// Cancelled.
TetgenResult run_tetgen(const TriangleSurface& surface, const MeshingOptions& options, double element_size,
                        const ProcessLimits& limits, const Monitor& monitor = {});

}  // namespace griffith
