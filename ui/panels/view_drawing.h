#pragma once

#include <string>
#include <vector>

#include "ui/model/gizmo.h"
#include "ui/model/region_outline.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

// Drawing and dragging over the picture.

/// Color of an item that the mouse holds or points at.
inline constexpr ImU32 kHeldColor = IM_COL32(255, 214, 92, 255);
/// Rim of lines, so that they stand out from a picture of any color.
inline constexpr ImU32 kRimColor = IM_COL32(16, 18, 22, 150);

/// Returns the picture's camera at the size at which it is drawn.
ViewCamera view_camera(const Panel& panel);
/// Returns the point of the picture under the mouse [pixels].
Vec2 pixel_of(const Panel& panel, ImVec2 mouse);
ImVec2 on_screen(const Panel& panel, const Vec2& pixel);

/// Returns the increments of a drag: those of a pixel at that point or, while it snaps, round ones that suit the size
/// of all bodies. Ctrl inverts the setting of snapping.
DragSteps drag_steps(const Panel& panel, const Vec3& place);
/// Returns the drawn size of unbounded regions [m].
double region_size(const Panel& panel);

/// Draws the parts of lines in front of the eye. The lines are in a rest space with the given `pose`.
void draw_world_lines(const Panel& panel, ImDrawList* list, const std::vector<RegionLine>& lines, const Pose& pose,
                      ImU32 color);
/// Writes the result of a drag next to `place`, that of the cursor, within the picture.
void draw_readout(const Panel& panel, ImDrawList* list, const std::string& text,
                  ImVec2 place = ImGui::GetIO().MousePos);

}  // namespace griffith::ui
