#include "renderer/hidden_backs.h"

#include <algorithm>

namespace griffith::render {
namespace {

using Eigen::Vector3d, Eigen::Vector3f;

/// True if the origin lies to the left of the line from a to b, seen along the y axis. It is true for exactly one of a
/// line and its reverse, so that a ray through an edge meets one of the two triangles.
bool is_left(const Vector3d& a, const Vector3d& b) {
  const double area = a.x() * b.z() - a.z() * b.x();
  if (area != 0) return area > 0;
  return a.x() != b.x() ? a.x() < b.x() : a.z() < b.z();
}

/// Returns the crossing of a triangle by the ray from the origin along the y axis: 1 in one direction, −1 in the other,
/// 0 for none.
int crossing(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const bool left = is_left(a, b);
  if (is_left(b, c) != left || is_left(c, a) != left) return 0;
  const Vector3d normal = (b - a).cross(c - a);
  const bool above = normal.y() > 0 ? normal.dot(a) > 0 : normal.dot(a) < 0;
  return above ? (left ? 1 : -1) : 0;
}

}  // namespace

HiddenBacks hidden_backs(const DrawScene& scene, bool glass) {
  const bool whole = scene.surface.opacity == 1 && !scene.visible;
  const bool alike = !glass || scene.embedded.selected_tet < 0;  // a selection is opaque, and not closed
  return {whole && alike && scene.surface.closed, whole && alike && scene.embedded.closed};
}

HiddenBacks hidden_backs_from(const DrawScene& scene, bool glass, const Vector3f& eye) {
  HiddenBacks hidden = hidden_backs(scene, glass);
  hidden.surface = hidden.surface && !is_inside(scene.surface, eye);
  hidden.embedded = hidden.embedded && !is_inside(scene.embedded, eye);
  return hidden;
}

bool is_inside(const Surface& surface, const Vector3f& place) {
  int windings = 0;
  const auto corner = [&](std::size_t i) { return Vector3d((surface.positions[i] - place).cast<double>()); };
  for (std::size_t i = 0; i + 2 < surface.positions.size(); i += 3)
    windings += crossing(corner(i), corner(i + 1), corner(i + 2));
  return windings != 0;
}

bool is_inside(const EmbeddedSurface& surface, const Vector3f& place) {
  return std::ranges::any_of(surface.tets, [&](const std::array<std::int32_t, 4>& tet) {
    const auto corner = [&](int i) {
      return surface.points[static_cast<std::size_t>(tet[static_cast<std::size_t>(i)])];
    };
    Eigen::Matrix3f edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = corner(i + 1) - corner(0);
    const Vector3f to_place = place - corner(0);
    const float volume = edges.determinant();
    float last = 1;
    for (int i = 0; i < 3; ++i) {
      Eigen::Matrix3f replaced = edges;
      replaced.col(i) = to_place;
      const float share = replaced.determinant() / volume;
      if (!(share >= 0)) return false;
      last -= share;
    }
    return last >= 0;
  });
}

}  // namespace griffith::render
