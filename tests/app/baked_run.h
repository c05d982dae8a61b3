#pragma once

#include "app/bake/run_baker.h"
#include "sim/world/world.h"

namespace griffith::app {

/// The frames from `first` to `last` of a scene's run, baked.
inline Bake baked_run(const Scene& scene, int first, int last, bool deformed = false) {
  World world(scene);
  RunBaker baker(world.frame(), scene);
  for (int step = 0; step < first; ++step) world.step();
  baker.follow(world.frame());
  for (int step = first; step < last; ++step) {
    world.step();
    baker.follow(world.frame());
  }
  return baker.finish(world.frame(), deformed);
}

inline Vec3 placed(const Pose& pose, const Vec3& point) { return pose.to_world(point); }

/// The triangles of all looks.
inline std::vector<std::array<int, 3>> all_triangles(const BakedMesh& mesh) {
  std::vector<std::array<int, 3>> all;
  for (const auto& triangles : mesh.triangles) all.insert(all.end(), triangles.begin(), triangles.end());
  return all;
}

}  // namespace griffith::app
