#pragma once

#include <optional>
#include <vector>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "ui/labels.h"
#include "ui/legend.h"

namespace griffith::app {

/// What the picture's colours mean; nothing when it shows no scalar. `locked`: the range was set by hand.
std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked);

/// The picture's labels where the camera sees them; none for what lies behind it.
std::vector<ui::PictureLabel> scene_labels(const render::DrawScene& picture, const render::Camera& camera,
                                           float aspect);

}  // namespace griffith::app
