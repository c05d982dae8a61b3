#pragma once

#include <string>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// The scene's camera of that name. An empty name means the first one or, if the scene has none, a view of everything
/// from the front, above and to the right. Throws InputError for a name that the scene doesn't have.
render::Camera scene_camera(const Scene& scene, const std::string& name, const render::DrawScene& picture,
                            float aspect);

/// A camera for scene files that shows what this one shows, with as few digits as that takes.
Camera described(const render::Camera& camera);

}  // namespace griffith::app
