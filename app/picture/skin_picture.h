#pragma once

#include <array>
#include <span>

#include "app/picture/skin.h"
#include "renderer/embedded_surface.h"

namespace griffith::app {

/// Adds a body's surface to `mesh`; its parts, one for each corner, are numbered from `first_part`, its pieces, one for
/// each part, from `first_piece`. `orders`: summation_orders() of the first frame.
void add_skin(const Frame& frame, std::span<const std::array<int, 4>> orders, const Skin& skin, int first_part,
              int first_piece, render::EmbeddedMesh& mesh);

}  // namespace griffith::app
