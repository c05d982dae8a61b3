#pragma once

#include <string>
#include <vector>

#include "ui/model/gizmo.h"
#include "ui/model/region_outline.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Color of an item that the mouse holds or points at.
inline constexpr ImU32 kHeldColor = IM_COL32(255, 214, 92, 255);
/// Rim of lines, so that they stand out from a picture of any color.
inline constexpr ImU32 kRimColor = IM_COL32(16, 18, 22, 150);

// Drawing and dragging in the view with the number panel.view.

/// Returns the rectangle of the view on the screen [pixels].
ScreenArea view_area(const Panel& panel);
/// True if the view is under the mouse, or the button went down in it. Only that view shows what is at the mouse.
bool is_active_view(const Panel& panel);
/// Returns the view's camera at the size at which it is drawn.
ViewCamera view_camera(const Panel& panel);
/// Returns the point of the view under the mouse [pixels].
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
/// Writes the result of a drag next to `place`, that of the cursor, within the view, if it is the active one.
void draw_readout(const Panel& panel, ImDrawList* list, const std::string& text,
                  ImVec2 place = ImGui::GetIO().MousePos);
/// Records a rectangle over the view as a widget, if it is the active one.
void tag_in_view(const Panel& panel, std::string tag, ImVec2 low, ImVec2 high, std::string text);

}  // namespace griffith::ui
