#pragma once

#include <array>
#include <vector>

#include "app/picture/placed_tets.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Whether a body shows the surface that it was filled from: not one with splinters of its own, nor one that is
/// remeshed, which would take the tets away from under it.
bool shows_surface(const BodyDescription& body);

/// The surface that a body was filled from, where it stands in the world at the start. Throws InputError when the file
/// cannot be read.
TriangleSurface placed_surface(const Scene& scene, const BodyDescription& body);

}  // namespace griffith::app
