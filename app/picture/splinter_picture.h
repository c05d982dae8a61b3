#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Adds the polygons of all splinters of a world in any of its frames: part, piece and polygon numbers are those of the
/// frame's parts, splinters and faces. `orders`: summation_orders() of the first frame. Bodies that show their original
/// surface (`skinned`, per scene body) have only walls.
void add_splinters(const Frame& frame, std::span<const std::array<int, 4>> orders,
                   std::span<const std::uint8_t> skinned, render::EmbeddedMesh& mesh);

/// Adds the carrier of each of their parts in this frame.
void add_carriers(const Frame& frame, std::vector<std::int32_t>& carriers);

}  // namespace griffith::app
