#pragma once

#include <string>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Returns the scene's camera of that name. An empty name gives the first camera or, without any, a view of everything
/// from the front right, above. Throws InputError for an unknown name.
render::Camera scene_camera(const Scene& scene, const std::string& name, const render::DrawScene& picture,
                            float aspect);

/// Returns a camera for scene files that shows the same view, with the fewest digits.
Camera described(const render::Camera& camera);

}  // namespace griffith::app
