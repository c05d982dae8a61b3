#pragma once

#include <filesystem>

#include "app/shared/shipped_thumbnails.h"
#include "renderer/image.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Returns a small picture of a scene through its first camera. A dynamic scene is shown in natural colors some steps
/// after its first crack, or after a fixed time without one; a static scene in its own view at the first equilibrium.
/// `file`: of the scene, for errors. Needs a current OpenGL context. Throws InputError if the world cannot be built.
render::Image thumbnail(const Scene& scene, const std::filesystem::path& file);

}  // namespace griffith::app
