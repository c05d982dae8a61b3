#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "app/picture/skin.h"
#include "renderer/embedded_surface.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Adds the polygons of all splinters of a world in any of its frames: part, piece and polygon numbers are those of the
/// frame's parts, splinters and faces. `orders`: summation_orders() of the first frame. Bodies that show their original
/// surface (`skinned`, per scene body) have only walls.
void add_splinters(const Frame& frame, std::span<const std::array<int, 4>> orders,
                   std::span<const std::uint8_t> skinned, render::EmbeddedMesh& mesh);

/// Adds the carrier of each of their parts in this frame.
void add_carriers(const Frame& frame, std::vector<std::int32_t>& carriers);

/// Adds a body's surface to `mesh`; its parts, one for each corner, are numbered from `first_part`, its pieces, one for
/// each part, from `first_piece`. `orders`: summation_orders() of the first frame.
void add_skin(const Frame& frame, std::span<const std::array<int, 4>> orders, const Skin& skin, int first_part,
              int first_piece, render::EmbeddedMesh& mesh);

}  // namespace griffith::app
