#pragma once

#include <filesystem>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

// Objects of everyday size that commands add, ready to be struck. Each stands on y = 0 around the origin.

/// Returns a table: a glass top of 1.2 x 0.7 m, 10 mm thick, on four wooden legs, 0.71 m high. Nothing is glued: the
/// top lies on the legs.
std::vector<BodyDescription> table();
/// Returns a wall of bricks in running bond, 2.5 x 2 x 0.25 m, its foot held.
std::vector<BodyDescription> brick_wall();
/// Returns a vase of earthenware, 0.52 m high with a wall of 30 mm. `surface`: its file, as written in the scene.
std::vector<BodyDescription> vase(const std::filesystem::path& surface);

/// Places bodies on the ground next to all others, or around the origin of an empty scene, under names that are free.
/// `frame`: of a world of the scene that may lack the last bodies.
std::vector<BodyDescription> placed(std::vector<BodyDescription> bodies, const Scene& scene, const Frame& frame);

}  // namespace griffith::app
