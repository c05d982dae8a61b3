#pragma once

#include <string_view>

#include "renderer/embedded_surface.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"

namespace griffith::app {

/// Surfaces of a body; EmbeddedStyle::material has three for each body.
enum class Look { outside, inside, mortar };
inline constexpr int kLooks = 3;

/// Returns the index of a scene body's look among the materials of a picture.
inline int look_index(int scene_body, Look look) { return kLooks * scene_body + static_cast<int>(look); }

/// Returns the look of a face of a splinter.
Look look_of(const SplinterFace& face);

/// Returns the key of the most similar preset, whose look the material gets.
std::string_view preset_alike(const Material& material);

/// Returns the natural looks of all bodies by look_index(): those of the most similar presets, with fibers along the
/// grain of splinters and noise in proportion to their size.
std::vector<render::EmbeddedMaterial> natural_materials(const Scene& scene);

}  // namespace griffith::app
