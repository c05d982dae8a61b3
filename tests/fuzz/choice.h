#pragma once

#include <cstddef>

#include "tests/random_values.h"

namespace griffith::fuzz {

using testing::RandomValues;

inline bool chance(RandomValues& random, double probability) { return random.uniform(0, 1) < probability; }

/// Any of `list`, which is not empty.
template <class List>
const auto& pick(RandomValues& random, const List& list) {
  return list[static_cast<std::size_t>(random.index(static_cast<int>(list.size())))];
}

}  // namespace griffith::fuzz
