#pragma once

#include <functional>

#include "sim/world/world.h"

namespace griffith::testing {

/// Shares of a static scene's loads, from `first` on by `increment` a step.
struct LoadRamp {
  double first = 0.9, last = 1.2, increment = 0.005;
};

/// Loads of the scene grow along the ramp. The share at which `broken` holds after a step for the first time; `last`
/// plus an increment when it never does. `inspect` sees the frame then.
inline double breaking_fraction(Scene scene, const LoadRamp& ramp, const std::function<bool(const Frame&)>& broken,
                                const std::function<void(const Frame&)>& inspect = {}) {
  const int steps = static_cast<int>((ramp.last - ramp.first) / ramp.increment + 0.5);
  scene.analysis = Analysis::static_;
  scene.simulation.time_step = 0.01;
  for (BodyDescription& body : scene.bodies) {
    std::vector<Load> loads;
    for (Load load : body.loads) {
      const Load full = load;
      load.force = ramp.first * full.force;
      load.traction = ramp.first * full.traction;
      load.acceleration = ramp.first * full.acceleration;
      loads.push_back(load);
      load.force = (ramp.last - ramp.first) * full.force;
      load.traction = (ramp.last - ramp.first) * full.traction;
      load.acceleration = (ramp.last - ramp.first) * full.acceleration;
      load.ramp = steps * scene.simulation.time_step;
      loads.push_back(load);
    }
    body.loads = loads;
  }
  World world(scene);
  for (int step = 1; step <= steps; ++step) {
    world.step();
    if (!broken(world.frame())) continue;
    if (inspect) inspect(world.frame());
    return ramp.first + step * ramp.increment;
  }
  return ramp.last + ramp.increment;
}

inline bool has_parted(const Frame& frame) { return frame.fragments > 0; }
inline bool has_cracked(const Frame& frame) { return !frame.crack_events.empty(); }

}  // namespace griffith::testing
