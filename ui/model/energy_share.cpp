#include "ui/model/energy_share.h"

#include <algorithm>
#include <cmath>

namespace griffith::ui {
namespace {

/// Relative error of sums over many elements and steps.
constexpr double kPrecision = 1e-12;

}  // namespace

double energy_noise(const Frame& frame, const Vec3& gravity, double size) {
  double mass = 0, stiffness = 0;  // [kg], Young's modulus times volume [J]
  for (const BodyView& body : frame.bodies) {
    const Material& material = frame.materials[body.scene_body];
    mass += body.mass;
    stiffness += material.young_modulus * body.mass / material.density;
  }
  return kPrecision * mass * gravity.norm() * size + kPrecision * kPrecision * stiffness;
}

EnergyShare energy_share(double energy, double whole, double noise) {
  if (!(std::abs(energy) > std::max(kPrecision * whole, noise))) return {};
  return {energy, whole > 0 ? std::clamp(energy / whole, 0.0, 1.0) : 0};
}

}  // namespace griffith::ui
