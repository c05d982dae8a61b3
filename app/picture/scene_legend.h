#pragma once

#include <optional>
#include <vector>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "ui/widgets/labels.h"
#include "ui/widgets/legend.h"

namespace griffith::app {

/// Returns the legend of the picture's colors; empty if it shows no scalar. `locked`: the range was set by the user.
std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked);

/// Returns the corner in which the legend hides least of the picture. It stays in its corner unless it hides something
/// there and less than half as much in another. `size`: of the picture [pixels], `scale`: of them per design pixel.
ui::LegendCorner legend_corner(const render::DrawScene& picture, const render::Camera& camera, const ui::Legend& legend,
                               const ui::Fonts& fonts, ImVec2 size, float scale);

/// Returns the fraction, 0..1, of a part of the picture that shows surfaces, nodes or spheres. The part is given in
/// fractions of the picture's width and height from its top left corner.
float covered_fraction(const render::DrawScene& picture, const render::Camera& camera, float aspect,
                       const Eigen::AlignedBox2f& part);

/// Returns a centered label that says what broke while it was scaled: "pane broke at E/256, σ/16". Empty if nothing
/// did. `y`: as in PictureLabel.
std::optional<ui::PictureLabel> scaling_label(const Scene& scene, const Frame& frame, float y);

/// Returns the picture's labels at their projected positions; none behind the camera.
std::vector<ui::PictureLabel> scene_labels(const render::DrawScene& picture, const render::Camera& camera,
                                           float aspect);

}  // namespace griffith::app
