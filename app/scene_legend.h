#pragma once

#include <optional>

#include "renderer/draw_scene.h"
#include "ui/legend.h"

namespace griffith::app {

/// What the picture's colours mean; nothing when it shows no scalar. `locked`: the range was set by hand.
std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked);

}  // namespace griffith::app
