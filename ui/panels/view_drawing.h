#pragma once

#include <string>
#include <vector>

#include "ui/model/gizmo.h"
#include "ui/model/region_outline.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

// What is drawn over the picture, and dragged in it.

/// Of what the mouse holds or points at.
inline constexpr ImU32 kHeldColor = IM_COL32(255, 214, 92, 255);
/// Round lines, so that they stand out from a picture of any colour.
inline constexpr ImU32 kRimColor = IM_COL32(16, 18, 22, 150);

/// The picture's camera, as large as it is drawn now.
ViewCamera view_camera(const Panel& panel);
/// The point of the picture under the mouse [pixels].
Vec2 pixel_of(const Panel& panel, ImVec2 mouse);
ImVec2 on_screen(const Panel& panel, const Vec2& pixel);

/// Round steps that suit the size of all bodies with Ctrl; else as fine as pixels at that place.
DragSteps drag_steps(const Panel& panel, const Vec3& place);
/// How large what has no end is drawn [m].
double region_size(const Panel& panel);

/// Lines of a rest space that stands at `pose`, as far as they are before the eye.
void draw_world_lines(const Panel& panel, ImDrawList* list, const std::vector<RegionLine>& lines, const Pose& pose,
                      ImU32 color);
/// What a drag comes to, beside the cursor, within the picture.
void draw_readout(const Panel& panel, ImDrawList* list, const std::string& text);

}  // namespace griffith::ui
