#pragma once

#include "sim/core/monitor.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// About how many tetrahedra the bodies will be made of, known before any is made. Surfaces with an element size are
/// read for that; meshes from files and surfaces that cannot be read do not count. Throws Cancelled when the monitor
/// says so.
double expected_tets(const Scene& scene, const Monitor& monitor = {});

/// About how many splinters the Voronoi and brick patterns will cut the bodies into; those of files, and of bodies from
/// files, do not count.
double expected_splinters(const Scene& scene);

}  // namespace griffith::app
