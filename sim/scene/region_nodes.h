#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/scene/region.h"

namespace griffith {

/// Returns per node of a body: 1 if it lies in the region, boundaries included, with a tolerance of 1e-9 of the body's
/// size. `points`: all of the body's nodes, in its rest space [m]; `numbers`: their indices in the body's mesh as built
/// or read, used by regions.
std::vector<std::uint8_t> nodes_in(const Region& region, std::span<const Vec3> points, std::span<const int> numbers);

}  // namespace griffith
