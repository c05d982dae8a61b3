#pragma once

#include "sim/core/monitor.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Estimates the number of tetrahedra of the bodies before any is made. Surfaces with an element size are read for
/// that; meshes from files and unreadable surfaces do not count. Throws Cancelled by the monitor.
double expected_tets(const Scene& scene, const Monitor& monitor = {});

/// Estimates the number of splinters of the Voronoi and brick patterns; patterns from files, and bodies from files, do
/// not count.
double expected_splinters(const Scene& scene);

}  // namespace griffith::app
