#include "tests/renderer/wall_scene.h"

#include <cmath>

namespace griffith::render {
namespace {

using Eigen::Vector3f;

void add_triangle(Surface& surface, const Vector3f& a, const Vector3f& b, const Vector3f& c, std::uint8_t flags) {
  surface.ids.push_back(static_cast<std::int32_t>(surface.ids.size()));
  surface.flags.push_back(flags);
  surface.positions.insert(surface.positions.end(), {a, b, c});
}

/// A box with the corners center ± half, turned by `rotation`; two triangles a face.
void add_box(Surface& surface, const Vector3f& center, const Vector3f& half, const Eigen::Matrix3f& rotation,
             bool crack_faces) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      Vector3f corner[4];
      for (int k = 0; k < 4; ++k) {
        Vector3f local;
        local[axis] = side * half[axis];
        local[(axis + 1) % 3] = (k == 1 || k == 2 ? 1.0f : -1.0f) * half[(axis + 1) % 3] * side;
        local[(axis + 2) % 3] = (k >= 2 ? 1.0f : -1.0f) * half[(axis + 2) % 3];
        corner[k] = center + rotation * local;
      }
      const bool cracked = crack_faces && axis != 2;
      const auto flags = static_cast<std::uint8_t>(kAllEdges | (cracked ? kCrackFace : 0));
      add_triangle(surface, corner[0], corner[1], corner[2], flags);
      add_triangle(surface, corner[0], corner[2], corner[3], flags);
    }
  }
}

void add_wall(Surface& surface) {
  constexpr int kColumns = 16, kRows = 12;
  constexpr float kHalf = 0.125f;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const Vector3f center((2 * column - kColumns + 1) * kHalf, (2 * row + 1) * kHalf, 0);
      if ((center - Vector3f(0.2f, 1.7f, 0)).norm() < 0.55f) continue;
      add_box(surface, center, Vector3f(kHalf, kHalf, 0.15f), Eigen::Matrix3f::Identity(), false);
    }
  }
}

void add_debris(Surface& surface) {
  for (int k = 0; k < 24; ++k) {
    const float angle = 2.4f * static_cast<float>(k), reach = 0.4f + 0.07f * static_cast<float>(k);
    const Vector3f half(0.05f + 0.03f * std::sin(angle * 3), 0.06f, 0.07f);
    const Vector3f center(0.2f + reach * std::cos(angle), 0.1f, 1.3f + 0.5f * reach * std::sin(angle));
    const Eigen::Matrix3f rotation =
        Eigen::AngleAxisf(angle, Vector3f(std::cos(angle), 1, std::sin(angle)).normalized()).toRotationMatrix();
    add_box(surface, center, half, rotation, true);
  }
}

}  // namespace

DrawScene wall_scene() {
  DrawScene scene;
  add_wall(scene.surface);
  add_debris(scene.surface);
  scene.surface.closed = true;
  scene.surface.flags[5] |= kSelected;
  scene.surface.flags[4] |= kSelected;
  scene.spheres = {{{0.2f, 1.7f, 0.9f}, 0.22f, {0.25f, 0.27f, 0.31f}, kBallId},
                   {{-1.3f, 0.3f, 1.4f}, 0.3f, {0.85f, 0.40f, 0.25f}, kBallId + 1}};
  scene.lines = {{{0.2f, 1.7f, 0.9f}, {0.2f, 2.0f, 3.0f}, {0.85f, 0.2f, 0.15f}}};
  scene.points = {{{-1.75f, 2.75f, 0.15f}, 9, {0.1f, 0.35f, 0.8f}}};
  scene.ground = Ground{0};
  return scene;
}

DrawScene scalar_wall_scene() {
  DrawScene scene = wall_scene();
  for (const Vector3f& place : scene.surface.positions) {
    const float distance = (place - Vector3f(0.2f, 1.7f, 0)).norm();
    scene.surface.scalars.push_back(std::exp(-1.5f * (distance - 0.4f)));
  }
  scene.surface.scalar_style = {ColorMap::viridis, 0, 1, "largest principal stress", "Pa"};
  return scene;
}

}  // namespace griffith::render
