#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/scene/region.h"

namespace griffith {

/// Per node of a body: 1 where it lies in the region, borders included, with a tolerance of 1e-9 of the body's size.
///   points   all of the body's nodes, in its rest space [m]
///   numbers  what regions name them by: their index in the body's mesh as built or read
std::vector<std::uint8_t> nodes_in(const Region& region, std::span<const Vec3> points, std::span<const int> numbers);

}  // namespace griffith
