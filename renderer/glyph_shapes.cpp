#include "renderer/glyph_shapes.h"

#include <cmath>
#include <numbers>

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr int kSides = 32;  // around the x axis

Vector3f round(int side, float x, float radius) {
  const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
  return {x, radius * std::cos(angle), radius * std::sin(angle)};
}

/// A ring of the surface of revolution: position on the axis, radius, and normal as (along, outward) at each end.
struct Profile {
  float x, radius, normal_x, normal_radius;
};

GlyphCorner on_profile(const Profile& profile, int side) {
  return {round(side, profile.x, profile.radius), round(side, profile.normal_x, profile.normal_radius)};
}

void add_ring(std::vector<GlyphCorner>& corners, const Profile& a, const Profile& b) {
  for (int side = 0; side < kSides; ++side) {
    const GlyphCorner a0 = on_profile(a, side), a1 = on_profile(a, side + 1);
    const GlyphCorner b0 = on_profile(b, side), b1 = on_profile(b, side + 1);
    if (a.radius > 0) corners.insert(corners.end(), {a0, a1, b0});
    if (b.radius > 0) corners.insert(corners.end(), {a1, b1, b0});
  }
}

}  // namespace

std::vector<GlyphCorner> arrow_shape() {
  constexpr float kHead = 0.68f, kShaft = 0.4f;  // position of the head's base; radius of the shaft
  std::vector<GlyphCorner> corners;
  add_ring(corners, {0, 0, -1, 0}, {0, kShaft, -1, 0});
  add_ring(corners, {0, kShaft, 0, 1}, {kHead, kShaft, 0, 1});
  add_ring(corners, {kHead, kShaft, -1, 0}, {kHead, 1, -1, 0});
  add_ring(corners, {kHead, 1, 1, 1 - kHead}, {1, 0, 1, 1 - kHead});
  return corners;
}

std::vector<GlyphCorner> ball_shape() {
  constexpr int kRings = 12;
  const auto at = [](int ring) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
    const float x = -std::cos(angle), radius = ring == 0 || ring == kRings ? 0 : std::sin(angle);
    return Profile{x, radius, x, radius};
  };
  std::vector<GlyphCorner> corners;
  for (int ring = 0; ring < kRings; ++ring) add_ring(corners, at(ring), at(ring + 1));
  return corners;
}

std::vector<GlyphCorner> disc_shape() {
  std::vector<GlyphCorner> corners;
  add_ring(corners, {0, 0, 1, 0}, {0, 1, 1, 0});
  return corners;
}

std::vector<GlyphCorner> box_shape() {
  std::vector<GlyphCorner> corners;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto corner = [&](float u, float v) {
        Vector3f place, normal = Vector3f::Zero();
        place[axis] = normal[axis] = side;
        place[(axis + 1) % 3] = side * u;
        place[(axis + 2) % 3] = v;
        return GlyphCorner{place, normal};
      };
      corners.insert(corners.end(), {corner(-1, -1), corner(1, -1), corner(1, 1)});
      corners.insert(corners.end(), {corner(-1, -1), corner(1, 1), corner(-1, 1)});
    }
  }
  return corners;
}

}  // namespace griffith::render
