#pragma once

#include <vector>

#include "renderer/draw_scene.h"
#include "sim/core/linear_algebra.h"

namespace griffith::app {

/// Colors with the same meaning in all layers.
namespace sign_color {
inline constexpr render::Rgb kTension = {0.84f, 0.18f, 0.15f};
inline constexpr render::Rgb kCompression = {0.16f, 0.38f, 0.80f};
inline constexpr render::Rgb kVelocity = {0.10f, 0.55f, 0.55f};
inline constexpr render::Rgb kImpulse = {0.93f, 0.60f, 0.10f};
inline constexpr render::Rgb kSupport = {0.18f, 0.55f, 0.25f};
inline constexpr render::Rgb kLoad = {0.62f, 0.20f, 0.66f};
inline constexpr render::Rgb kProbe = {0.95f, 0.78f, 0.10f};
inline constexpr render::Rgb kPlane = {0.98f, 0.80f, 0.22f};
inline constexpr render::Rgb kAbove = {0.95f, 0.55f, 0.10f};
inline constexpr render::Rgb kBelow = {0.10f, 0.60f, 0.75f};
}  // namespace sign_color

/// Adds an arrow from `start` along `way` [m], with a head of radius `thickness` [m], thinner if it is short. Adds
/// nothing if `way` is zero or not finite.
void add_arrow(std::vector<render::Glyph>& arrows, const Vec3& start, const Vec3& way, double thickness,
               const render::Rgb& color, std::int32_t id = render::kNoId);

/// Returns a disc of radius `radius` [m] perpendicular to a unit normal.
render::Glyph disc(const Vec3& center, const Vec3& normal, double radius, const render::Rgb& color, float opacity);

/// Returns a ball.
render::Glyph ball(const Vec3& center, double radius, const render::Rgb& color);

}  // namespace griffith::app
