#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The splinters of a world for its pictures, found in its first frame.
struct SplinterDisplay {
  std::shared_ptr<const render::EmbeddedMesh> splinters;  ///< null where no body has any
  std::vector<std::uint8_t> splintered;                   ///< per scene body: 1 when it has splinters
};

SplinterDisplay splinter_display(const Frame& frame);

/// The picture of a frame: surface coloured by view.quantity (natural colours for "material", one for each body or
/// splinter for "body" and "splinter"), cracks and `selected` marked, projectiles, ground. Bodies with splinters show
/// them if view.splinters says so. A triangle's id is its tet.
render::DrawScene draw_scene_from_frame(const Frame& frame, const SplinterDisplay& display, const Scene& scene,
                                        const ViewSettings& view, TetId selected);

}  // namespace griffith::app
