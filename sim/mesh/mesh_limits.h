#pragma once

#include <cstdint>

namespace griffith {

/// Largest number of tets in a scene, or in a mesh for one. A world takes about a kilobyte of memory for each.
inline constexpr std::int64_t kMaxTets = 4'000'000;
inline constexpr char kMaxTetsText[] = "4 million tetrahedra";

}  // namespace griffith
