#pragma once

#include <optional>
#include <span>

#include "app/picture/layer_picture.h"
#include "renderer/camera.h"

namespace griffith::app {

/// Returns the nearest symbol that a ray meets before `limit` [m]; null if there is none. `slack`: distance from the
/// ray at which axes and arrows count as met, per distance from its origin [-].
const LayerSymbol* symbol_on(const render::Ray& ray, std::span<const LayerSymbol> symbols, double slack, double limit);

}  // namespace griffith::app
