#pragma once

#include "sim/scene/scene.h"

namespace griffith::testing {

/// Without gravity, ground and fracture. `rate`: steps a second.
inline Scene weightless_scene(double rate) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1 / rate;
  scene.simulation.fracture = false;
  return scene;
}

/// Brick with another strength; toughness and strength in proportion, so that `scale` orders the damage.
inline Material brick(double scale) {
  Material material;
  material.tensile_strength *= scale;
  material.fracture_toughness *= scale;
  return material;
}

/// A wall of `size` on the ground, its foot held, made of `material`.
inline BodyDescription wall(const Vec3& size, double element_size, const Material& material) {
  BodyDescription body;
  body.name = "wall";
  body.shape = BoxShape{size, Vec3::Constant(element_size), BoxPattern::kuhn};
  body.position = Vec3(0, size.y() / 2, 0);
  body.material = material;
  body.supports = {{HalfSpaceRegion{Vec3(0, -size.y() / 2, 0), -Vec3::UnitY()}}};
  return body;
}

/// Three shots of the paper at the upper half of a wall.
inline ProjectileBurst shots(double wall_height) {
  ProjectileBurst burst;
  burst.count = 3;
  burst.start = 0.05;
  burst.position = Vec3(0.2, 0.6 * wall_height, 3);
  return burst;
}

inline Scene shot_wall(const Vec3& size, double element_size, const Material& material) {
  Scene scene;
  scene.bodies = {wall(size, element_size, material)};
  scene.projectiles = {shots(size.y())};
  return scene;
}

/// A free block in weightless space that a sphere strikes.
inline Scene struck_block(const Material& material) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription block;
  block.shape = BoxShape{Vec3(2, 2, 0.5), Vec3::Constant(0.5), BoxPattern::five_tet};
  block.material = material;
  scene.bodies = {block};
  ProjectileBurst shot;
  shot.position = Vec3(0.3, 0.2, 1);
  scene.projectiles = {shot};
  return scene;
}

/// A free pane of soft glass, 1 m wide, in weightless space that a heavy ball strikes after 0.02 s.
inline Scene shot_pane(int cells, double time_step) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  BodyDescription pane;
  pane.shape = BoxShape{Vec3(1, 1, 0.02), Vec3(1.0 / cells, 1.0 / cells, 0.02), BoxPattern::five_tet};
  pane.material.young_modulus = 7e8;
  pane.material.density = 2500;
  pane.material.tensile_strength = 2e6;
  pane.material.fracture_toughness = 7.6e4;
  scene.bodies = {pane};
  ProjectileBurst shot;
  shot.position = Vec3(0.1, 0.1, 0.6);
  shot.speed = 25;
  shot.mass = 20;
  shot.radius = 0.085;
  scene.projectiles = {shot};
  return scene;
}

}  // namespace griffith::testing
