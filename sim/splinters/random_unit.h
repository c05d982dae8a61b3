#pragma once

#include <cstdint>

namespace griffith {

/// Returns a pseudorandom number in [0, 1) that depends only on its arguments (the finalizer of SplitMix64; Steele, Lea
/// & Flood 2014), so that a pattern near a place does not depend on its extent.
inline double random_unit(int seed, std::int64_t a, std::int64_t b = 0, std::int64_t c = 0, int component = 0) {
  std::uint64_t x = static_cast<std::uint64_t>(seed);
  for (const std::int64_t next : {a, b, c, static_cast<std::int64_t>(component)}) {
    x = (x + 0x9e3779b97f4a7c15u) ^ static_cast<std::uint64_t>(next);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    x ^= x >> 31;
  }
  return static_cast<double>(x >> 11) * 0x1p-53;
}

}  // namespace griffith
