#pragma once

#include <imgui.h>

#include <array>
#include <string>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// Largest number of pictures of the scene in the viewport.
inline constexpr int kMaxViews = 4;

/// Direction from which a view looks: the user's camera, or an axis.
enum class ViewSide { camera, top, bottom, front, back, right, left };
inline constexpr std::array<const char*, 7> kViewSideNames = {"Camera", "Top",   "Bottom", "Front",
                                                              "Back",   "Right", "Left"};

/// Returns the direction from the scene toward the eye of a side that is not the camera's; length 1.
Vec3 toward_side(ViewSide side);

/// The viewport in four: a view each from above and by the user's camera, below them from the front and a side. All
/// look at the camera's target. Views are numbered as in `sides`; a viewport with one picture has view 0.
struct FourViews {
  bool shown = false;
  int active = 0;  ///< view under the mouse, or in which the button went down
  std::array<ViewSide, kMaxViews> sides = {ViewSide::camera, ViewSide::top, ViewSide::front, ViewSide::right};
  std::array<std::string, kMaxViews> quantities;  ///< quantity of the colors of views 1 to 3; empty: that of view 0

  int count() const { return shown ? kMaxViews : 1; }
  bool operator==(const FourViews&) const = default;
};

/// Part of the viewport with a view, from its upper left corner [pixels].
struct ViewArea {
  ImVec2 low, size;
};
/// Returns the part with a view of a viewport of that size.
ViewArea area_of(const FourViews& views, int view, ImVec2 viewport);

/// Point of a view, from its upper left corner, 0..1.
struct ViewPoint {
  int view = 0;
  Vec2 place;
};
/// Returns the view at a point of the viewport, 0..1 from its upper left corner.
ViewPoint view_at(const FourViews& views, const Vec2& cursor, ImVec2 viewport);
/// Returns that point in a view, which may be another one.
Vec2 place_in(const FourViews& views, int view, const Vec2& cursor, ImVec2 viewport);

}  // namespace griffith::ui
