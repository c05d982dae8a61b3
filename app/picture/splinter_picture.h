#pragma once

#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Adds the polygons of all splinters of a world, in any of its frames: part, piece and polygon numbers are those of
/// the frame's parts, splinters and faces.
void add_splinters(const Frame& frame, render::EmbeddedMesh& mesh);

/// Adds what carries each of their parts in this frame.
void add_carriers(const Frame& frame, std::vector<std::int32_t>& carriers);

}  // namespace griffith::app
