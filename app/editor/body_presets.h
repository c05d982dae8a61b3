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
/// Returns the wall of scenes/brick_wall.json: bricks in running bond, 2.5 x 2 x 0.25 m, its foot held.
std::vector<BodyDescription> brick_wall();
/// Returns the vase of earthenware of scenes/vase_shot.json, 0.52 m high with a wall of 30 mm. `sample`: that file;
/// `folder`: that of the scene which gets the vase, or an empty path. Throws InputError if the file has an error.
std::vector<BodyDescription> vase(const std::filesystem::path& sample, const std::filesystem::path& folder);

/// Places bodies on the ground next to all others, or around the origin of an empty scene, under names that are free.
/// `frame`: of a world of the scene that may lack the last bodies.
std::vector<BodyDescription> placed(std::vector<BodyDescription> bodies, const Scene& scene, const Frame& frame);

}  // namespace griffith::app
