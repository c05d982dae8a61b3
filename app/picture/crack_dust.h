#pragma once

#include "app/picture/shown_mesh.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What cracks throw out as they open: puffs of dust, which fade, and crumbs, which fall and stay on the ground or on
/// bodies as they lie now. An effect: nothing of the simulation depends on it, and it depends on the frame alone.
struct CrackDust {
  std::vector<render::Puff> puffs;
  std::vector<render::Sphere> crumbs;
};
CrackDust crack_dust(const Frame& frame, const Scene& scene, const HiddenBodies& hidden = {});

}  // namespace griffith::app
