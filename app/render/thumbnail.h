#pragma once

#include <filesystem>

#include "app/shared/shipped_thumbnails.h"
#include "renderer/image.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// A small picture of what happens in a scene, through its first camera, in natural colours or, of a static scene, its
/// view: some steps after the first crack,
/// or when a while has passed without one; of a static scene the first equilibrium. `file`: of the scene, for errors.
/// Needs a current OpenGL context. Throws InputError when its world cannot be built.
render::Image thumbnail(const Scene& scene, const std::filesystem::path& file);

}  // namespace griffith::app
