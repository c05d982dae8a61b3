#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The corners of each tet by their rest positions. Summed in this order, a point of a face comes out the same to the
/// bit from both tets at the face, so that no background shines through between what they carry. Cracks do not change
/// it: a copy of a node has its rest position.
std::vector<std::array<int, 4>> summation_orders(const Frame& frame);

/// Weights of a tet's corners in that order, without what is rounding alone.
render::Weights ordered(const Weights& weights, const std::array<int, 4>& order);

/// The nodes of all tets in the `orders` that they had at the start, for the renderer; remeshing, which adds tets,
/// takes none that carries anything.
std::vector<std::array<std::int32_t, 4>> ordered_tets(const Frame& frame, std::span<const std::array<int, 4>> orders);

}  // namespace griffith::app
