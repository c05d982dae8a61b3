#pragma once

#include <Eigen/LU>
#include <algorithm>

#include "sim/world/world.h"

namespace griffith::testing {

/// Point of material.
struct Place {
  int tet = 0;
  Vec3 weights = Vec3::Zero();
};

/// Returns the material at `position` [m], or the nearest.
inline Place place_at(const Frame& frame, const Vec3& position) {
  Place best;
  double closest = -1e9;
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i) {
    const auto at = [&](int corner) { return frame.nodes.positions[frame.elements.tets[i][corner]]; };
    Mat3 edges;
    for (int corner = 1; corner < 4; ++corner) edges.col(corner - 1) = at(corner) - at(0);
    const Vec3 weights = edges.inverse() * (position - at(0));
    const double inside = std::min(weights.minCoeff(), 1 - weights.sum());
    if (inside <= closest) continue;
    closest = inside;
    const Vec3 kept = weights.cwiseMax(0);
    best = {static_cast<int>(i), kept / std::max(1.0, kept.sum())};
  }
  return best;
}

/// A free block of 0.4 m in empty space, of one cell (five tets; the middle one has its center) or more.
inline Scene floating_block(int cells = 1, double young_modulus = 1e9) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  BodyDescription block;
  block.shape = BoxShape{Vec3::Constant(0.4), Vec3::Constant(0.4 / cells), BoxPattern::five_tet};
  block.position = Vec3(0, 2, 0);
  block.material.young_modulus = young_modulus;
  scene.bodies = {block};
  return scene;
}

/// Two stones that lie on one another on the ground.
inline Scene stack() {
  Scene scene = floating_block(2, 1e9);
  scene.simulation.time_step = 1.0 / 60;
  scene.gravity = Vec3(0, -9.80665, 0);
  scene.ground = Ground{};
  scene.bodies[0].position.y() = 0.2;
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "upper";
  scene.bodies[1].position.y() = 0.6;
  return scene;
}

}  // namespace griffith::testing
