#include "ui/model/view_layers.h"

#include <algorithm>
#include <cmath>

#include "sim/scene/quantities.h"

namespace griffith::ui {
namespace {

bool lies_inside(ViewLayer layer) {
  switch (layer) {
    case ViewLayer::stress_axes:
    case ViewLayer::stress_ellipsoids:
    case ViewLayer::separation_axes:
    case ViewLayer::contacts:
    case ViewLayer::fracture_planes:
    case ViewLayer::candidate_plane:
    case ViewLayer::element_forces:
    case ViewLayer::body_frames:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool shows_layer(const ViewSettings& view, ViewLayer layer) {
  return std::ranges::find(view.layers, layer) != view.layers.end();
}

void show_layer(ViewSettings& view, ViewLayer layer, bool show) {
  constexpr double kSeeThrough = 0.25;
  std::erase(view.layers, layer);
  if (!show) return;
  view.layers.push_back(layer);
  std::ranges::sort(view.layers);
  if (lies_inside(layer) && view.opacity == 1 && !view.slice && view.elements == ElementStyle::surface)
    view.opacity = kSeeThrough;
}

bool parts_at_zero(const ViewSettings& view) {
  constexpr double kSame = 1e-6;  // relative tolerance for a rounded range
  if (view.color_map != "automatic") return false;
  const Quantity* quantity = find_view_quantity(view.quantity);
  if (!quantity || !quantity->is_signed) return false;
  return !view.range || std::abs(view.range->sum()) <= kSame * view.range->cwiseAbs().maxCoeff();
}

SlicePlane middle_slice(const Vec3& low, const Vec3& high, const Vec3& toward_eye) {
  Eigen::Index axis = 0;
  toward_eye.cwiseAbs().maxCoeff(&axis);
  const Vec3 normal = toward_eye[axis] < 0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis));
  return {normal, normal.dot(0.5 * (low + high))};
}

}  // namespace griffith::ui
