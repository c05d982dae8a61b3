#pragma once

#include <array>
#include <vector>

#include "app/picture/placed_tets.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// True if a body shows its original surface: it has no splinters of its own, and is not remeshed, which would remove
/// the tets below the surface.
bool shows_surface(const BodyDescription& body);

/// Returns the original surface of a body in its initial placement. Throws InputError if the file cannot be read.
TriangleSurface placed_surface(const Scene& scene, const BodyDescription& body);

}  // namespace griffith::app
