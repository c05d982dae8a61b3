#pragma once

#include <optional>
#include <vector>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/widgets/labels.h"
#include "ui/widgets/legend.h"

namespace griffith::app {

/// What the picture's colours mean; nothing when it shows no scalar. `locked`: the range was set by hand.
std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked);

/// The corner in which the legend covers least of what the picture shows. It stays in the one where it is unless it
/// covers something there and less than half as much in another. `size`: of the picture [pixels], `scale`: of them per
/// design pixel.
ui::LegendCorner legend_corner(const render::DrawScene& picture, const render::Camera& camera, const ui::Legend& legend,
                               const ui::Fonts& fonts, ImVec2 size, float scale);

/// What share of a part of the picture, given in shares of its width and height from its top left corner, shows
/// surfaces, bodies' nodes or spheres, 0 to 1.
float covered_fraction(const render::DrawScene& picture, const render::Camera& camera, float aspect,
                       const Eigen::AlignedBox2f& part);

/// That what is seen broke while it was scaled, in the middle: "pane broke at E/256, σ/16". Nothing where nothing did.
/// `y`: as PictureLabel.
std::optional<ui::PictureLabel> scaling_label(const Scene& scene, const Frame& frame, float y);

/// The picture's labels where the camera sees them; none for what lies behind it.
std::vector<ui::PictureLabel> scene_labels(const render::DrawScene& picture, const render::Camera& camera,
                                           float aspect);

}  // namespace griffith::app
