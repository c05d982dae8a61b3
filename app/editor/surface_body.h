#pragma once

#include <functional>

#include "sim/core/monitor.h"
#include "sim/world/world.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Returns a function that adds a body filled from the requested surface file to the scene, next to the others.
/// `frame`: of a world that may lack the last bodies. Throws InputError if no file was named.
std::function<Scene(const Monitor&)> scene_with_surface(const ui::SurfaceRequest& request, Scene scene,
                                                        const Frame& frame);

/// Describes the new body of that index: its size, the quality of its elements and its warnings.
ui::WorkReport surface_report(const World& world, const Scene& scene, int body);

}  // namespace griffith::app
