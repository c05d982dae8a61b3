#pragma once

#include <vector>

#include "app/bake/bake.h"

namespace griffith::app {

/// Returns the frames whose poses determine the motion of an object: the first one, and both ends of all intervals at
/// rest.
inline std::vector<int> pose_keys(const BakedObject& object) {
  const auto rests = [&](int from) {
    const Pose &a = object.poses[from], &b = object.poses[from + 1];
    return a.translation == b.translation && a.rotation.coeffs() == b.rotation.coeffs();
  };
  std::vector<int> keys = {0};
  for (int i = 1; i < std::ssize(object.poses); ++i)
    if (!rests(i - 1) || (i + 1 < std::ssize(object.poses) && !rests(i))) keys.push_back(i);
  return keys;
}

}  // namespace griffith::app
