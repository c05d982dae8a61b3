#pragma once

#include <vector>

#include "app/bake/bake.h"

namespace griffith::app {

/// The poses that tell where a thing was in all frames, by their numbers: the first one, and the ends of all stretches
/// in which it rests.
inline std::vector<int> pose_keys(const BakedThing& thing) {
  std::vector<int> keys = {0};
  for (int i = 1; i < std::ssize(thing.poses); ++i) {
    const bool same_before = thing.poses[i] == thing.poses[i - 1];
    const bool same_behind = i + 1 == std::ssize(thing.poses) || thing.poses[i] == thing.poses[i + 1];
    if (!same_before || !same_behind) keys.push_back(i);
  }
  return keys;
}

}  // namespace griffith::app
