#pragma once

#include "app/picture/shown_mesh.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Debris from opening cracks: puffs of dust, which fade, and crumbs, which fall and stay on the ground or on bodies in
/// their current state. A visual effect: the simulation does not depend on it, and it depends on the frame alone.
struct CrackDust {
  std::vector<render::Puff> puffs;
  std::vector<render::Sphere> crumbs;
};
CrackDust crack_dust(const Frame& frame, const Scene& scene, const HiddenBodies& hidden = {});

}  // namespace griffith::app
