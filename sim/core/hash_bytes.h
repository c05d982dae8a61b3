#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/core/bytes.h"

namespace griffith {

/// Returns the XXH3 hash (Collet 2019) of bytes, equal on every machine. `seed`: the hash of the preceding bytes.
std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed = 0);

/// Returns the hash of numbers as stored in memory. T has no padding.
template <class T>
std::uint64_t hash_values(std::span<const T> values, std::uint64_t seed = 0) {
  static_assert(!std::is_pointer_v<T>);
  return hash_bytes(bytes_of(values), seed);
}
template <class T>
std::uint64_t hash_values(const std::vector<T>& values, std::uint64_t seed = 0) {
  return hash_values(std::span<const T>(values), seed);
}

}  // namespace griffith
