#include "sim/core/hash_bytes.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace griffith {

std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed) {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

}  // namespace griffith
