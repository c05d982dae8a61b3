#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Adds the polygons of all splinters of a world, in any of its frames: part, piece and polygon numbers are those of
/// the frame's parts, splinters and faces. `orders`: summation_orders() of the first frame. Of bodies that show the
/// surface they were made from (`skinned`, per scene body) walls alone are ever drawn.
void add_splinters(const Frame& frame, std::span<const std::array<int, 4>> orders,
                   std::span<const std::uint8_t> skinned, render::EmbeddedMesh& mesh);

/// Adds what carries each of their parts in this frame.
void add_carriers(const Frame& frame, std::vector<std::int32_t>& carriers);

}  // namespace griffith::app
