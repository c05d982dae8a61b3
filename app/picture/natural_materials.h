#pragma once

#include <string_view>

#include "renderer/embedded_surface.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"

namespace griffith::app {

/// How the three matters of a body look: what EmbeddedStyle::material counts, three a body.
enum class Look { outside, inside, mortar };
inline constexpr int kLooks = 3;

/// Which material of a picture's splinters shows that look of a scene body.
inline int look_index(int scene_body, Look look) { return kLooks * scene_body + static_cast<int>(look); }

/// What matter a face of a splinter shows.
Look look_of(const SplinterFace& face);

/// The key of the preset that a material is most like, by which it is seen.
std::string_view preset_alike(const Material& material);

/// The natural look of all bodies, by look_index(): of the preset that is most alike, with fibres
/// along the grain of splinters that have one and noise in proportion to their size.
std::vector<render::EmbeddedMaterial> natural_materials(const Scene& scene);

}  // namespace griffith::app
