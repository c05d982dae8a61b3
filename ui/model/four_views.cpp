#include "ui/model/four_views.h"

#include <cmath>

namespace griffith::ui {
namespace {

/// Column and row of each view.
constexpr std::array<std::array<int, 2>, kMaxViews> kCells = {{{1, 0}, {0, 0}, {0, 1}, {1, 1}}};

}  // namespace

Vec3 toward_side(ViewSide side) {
  switch (side) {
    case ViewSide::top:
      return Vec3::UnitY();
    case ViewSide::bottom:
      return -Vec3::UnitY();
    case ViewSide::back:
      return -Vec3::UnitZ();
    case ViewSide::right:
      return Vec3::UnitX();
    case ViewSide::left:
      return -Vec3::UnitX();
    case ViewSide::camera:
    case ViewSide::front:
      break;
  }
  return Vec3::UnitZ();
}

ViewArea area_of(const FourViews& views, int view, ImVec2 viewport) {
  if (!views.shown) return {{0, 0}, viewport};
  const auto [column, row] = kCells[static_cast<std::size_t>(view)];
  const ImVec2 middle = {std::floor(viewport.x / 2), std::floor(viewport.y / 2)};
  return {{column * middle.x, row * middle.y},
          {column == 0 ? middle.x : viewport.x - middle.x, row == 0 ? middle.y : viewport.y - middle.y}};
}

ViewPoint view_at(const FourViews& views, const Vec2& cursor, ImVec2 viewport) {
  ViewPoint point;
  for (int view = 0; view < views.count(); ++view) {
    const ViewArea area = area_of(views, view, viewport);
    if (cursor.x() * viewport.x >= area.low.x && cursor.y() * viewport.y >= area.low.y &&
        cursor.x() * viewport.x < area.low.x + area.size.x && cursor.y() * viewport.y < area.low.y + area.size.y)
      point.view = view;
  }
  point.place = place_in(views, point.view, cursor, viewport);
  return point;
}

Vec2 place_in(const FourViews& views, int view, const Vec2& cursor, ImVec2 viewport) {
  if (!views.shown) return cursor;
  const ViewArea area = area_of(views, view, viewport);
  return {(cursor.x() * viewport.x - area.low.x) / area.size.x, (cursor.y() * viewport.y - area.low.y) / area.size.y};
}

}  // namespace griffith::ui
