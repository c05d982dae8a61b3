#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns the order of the corners of each tet by rest position. Summed in this order, a point of a face has the same
/// bits from both adjacent tets, so that no background shines through between them. Cracks do not change the order: a
/// copy of a node has its rest position.
std::vector<std::array<int, 4>> summation_orders(const Frame& frame);

/// Returns the weights of a tet's corners in that order, with rounding errors set to 0.
render::Weights ordered(const Weights& weights, const std::array<int, 4>& order);

/// Returns the nodes of all initial tets in the `orders`, for the renderer. Remeshing adds tets but moves none that
/// carries anything.
std::vector<std::array<std::int32_t, 4>> ordered_tets(const Frame& frame, std::span<const std::array<int, 4>> orders);

}  // namespace griffith::app
