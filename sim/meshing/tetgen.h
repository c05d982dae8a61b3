#pragma once

#include <string>

#include "sim/core/monitor.h"
#include "sim/core/process.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/meshing_options.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// What TetGen made of a surface.
struct TetgenResult {
  TetSoup soup;
  std::string refusal;  ///< why there is none; empty when it went well
  std::string remedy;   ///< what might help besides another surface, such as more time; else empty
};

/// Fills a surface with tets by running TetGen (Si 2015) as a program of its own in a temporary folder. Faces on the
/// surface get edges of about `element_size` [m], where the surface's own triangles are not smaller. Throws Cancelled.
TetgenResult run_tetgen(const TriangleSurface& surface, const MeshingOptions& options, double element_size,
                        const ProcessLimits& limits, const Monitor& monitor = {});

}  // namespace griffith
