#include "app/picture/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/color.h"

namespace griffith::app {
namespace {

/// Returns the digits of `index` after the point in reverse order, a number in 0..1 (van der Corput 1935).
double radical_inverse(int index, int base) {
  double result = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) result += digit * (index % base);
  return result;
}

std::uint8_t encoded(float light) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(render::srgb_from_linear(light), 0.0f, 1.0f)));
}

}  // namespace

float lens_radius(const render::Camera& camera) {
  constexpr float kAperture = 0.009f;  // in heights of the view at the target
  constexpr float kLargest = 0.015f;   // [m], of a 50 mm lens at f/1.7: with larger ones, houses look like models
  return std::min(kAperture * height_at_target(camera), kLargest);
}

std::vector<Exposure> exposures(int count, int times) {
  constexpr double kGoldenAngle = 2.3999632;  // Vogel 1979
  std::vector<Exposure> result;
  for (int i = 0; i < count; ++i) {
    const int at_time = i * times / count;
    // Points of one time are spread over the whole lens.
    const int point = i % (count / times) * times + at_time;
    const double radius = std::sqrt((point + 0.5) / count), angle = kGoldenAngle * point;
    const Eigen::Vector2d lens(radius * std::cos(angle), radius * std::sin(angle));
    const Eigen::Vector2d pixel(radical_inverse(i + 1, 2) - 0.5, radical_inverse(i + 1, 3) - 0.5);
    result.push_back({lens.cast<float>(), pixel.cast<float>(), (at_time + 0.5) / times - 1});
  }
  return result;
}

render::Camera exposed(const render::Camera& camera, const Exposure& exposure, int height) {
  render::Camera moved = camera;
  const float radius = lens_radius(camera) / height_at_target(camera);
  moved.position = render::pan(camera, radius * exposure.lens.x(), radius * exposure.lens.y()).position;
  const Eigen::Vector2f shift = exposure.pixel / static_cast<float>(height);
  return render::pan(moved, shift.x(), shift.y());
}

LaterFrame::LaterFrame(const Frame& frame, double time)
    : moved_(frame), projectiles_(frame.projectiles.begin(), frame.projectiles.end()) {
  const auto nodes = frame.nodes.positions.size();
  positions_.reserve(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const NodeId node(static_cast<std::int64_t>(i));
    positions_.push_back(frame.nodes.positions[node] + time * frame.nodes.velocities[node]);
  }
  for (ProjectileView& projectile : projectiles_) projectile.position += time * projectile.velocity;
  moved_.nodes.positions = positions_;
  moved_.projectiles = projectiles_;
  moved_.time += time;  // for dust
}

void ImageSum::add(const render::Image& image) {
  static const auto light = [] {
    std::array<float, 256> table;
    for (int i = 0; i < 256; ++i)
      table[static_cast<std::size_t>(i)] = render::linear_from_srgb(static_cast<float>(i) / 255);
    return table;
  }();
  width_ = image.width, height_ = image.height;
  sums_.resize(image.rgba.size());
  for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += light[image.rgba[i]];
  ++count_;
}

render::Image ImageSum::mean() const {
  render::Image image{width_, height_, std::vector<std::uint8_t>(sums_.size(), 255)};
  for (std::size_t i = 0; i < sums_.size(); ++i)
    if (i % 4 != 3) image.rgba[i] = encoded(sums_[i] / static_cast<float>(count_));
  return image;
}

}  // namespace griffith::app
