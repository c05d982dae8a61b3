#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/core/bytes.h"

namespace griffith {

/// XXH3's hash of bytes (Collet 2019): the same on every machine. `seed`: the hash of what came before.
std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed = 0);

/// The hash of numbers as they lie in memory: T must be free of padding.
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
