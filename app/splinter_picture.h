#pragma once

#include <memory>

#include "renderer/embedded_surface.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The polygons of all splinters of a world, in any of its frames; null when it has none.
std::shared_ptr<const render::EmbeddedMesh> splinter_mesh(const Frame& frame);

/// What moves those polygons in this frame, without colours.
render::EmbeddedSurface splinter_surface(const Frame& frame, std::shared_ptr<const render::EmbeddedMesh> mesh);

}  // namespace griffith::app
