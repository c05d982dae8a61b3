#include "app/editor/thickness.h"

#include "sim/scene/body_pose.h"
#include "ui/model/scaled_shape.h"

namespace griffith::app {
namespace {

std::optional<Thickness> extent(const BoxShape& box) {
  int shortest = 0;
  const double length = box.size.minCoeff(&shortest);
  return Thickness{Vec3::Unit(shortest), length};
}
std::optional<Thickness> extent(const CylinderShape& cylinder) {
  if (cylinder.length < 2 * cylinder.radius) return Thickness{Vec3::UnitZ(), cylinder.length};
  return Thickness{Vec3(1, 1, 0), 2 * cylinder.radius};
}
std::optional<Thickness> extent(const DiscShape& disc) { return Thickness{Vec3::UnitZ(), disc.thickness}; }
std::optional<Thickness> extent(const SphereShape& sphere) { return Thickness{Vec3::Ones(), 2 * sphere.radius}; }
std::optional<Thickness> extent(const PlateWithHoleShape& plate) { return Thickness{Vec3::UnitZ(), plate.size.z()}; }
std::optional<Thickness> extent(const NotchedBeamShape& beam) { return Thickness{Vec3::UnitZ(), beam.size.z()}; }
std::optional<Thickness> extent(const MeshFileShape&) { return std::nullopt; }
std::optional<Thickness> extent(const SurfaceShape&) { return std::nullopt; }

/// Effect of a factor of thickness on a body.
struct Stretch {
  Vec3 scale = Vec3::Ones();  ///< along the axes of the shape
  Vec3 shift = Vec3::Zero();  ///< displacement of its origin [m]
};

Stretch stretch_by(const BodyDescription& body, double factor, const Vec3& gravity) {
  constexpr double kLies = 0.5;  // cosine of the angle between thickness and vertical direction
  const std::optional<Thickness> thickness = thickness_of(body.shape);
  if (!thickness) return {};
  Stretch stretch{Vec3::Ones() + (factor - 1) * thickness->directions};
  const Quat rotation = pose_of(body).rotation;
  const Vec3 down = thickness->directions.cwiseProduct(rotation.conjugate() * gravity.normalized());
  if (down.norm() > kLies) stretch.shift = rotation * down.normalized() * (1 - factor) * thickness->length / 2;
  return stretch;
}

}  // namespace

std::optional<Thickness> thickness_of(const Shape& shape) {
  return std::visit([](const auto& kind) { return extent(kind); }, shape);
}

BodyDescription thickened(BodyDescription body, double factor, const Vec3& gravity) {
  const Stretch by = stretch_by(body, factor, gravity);
  ui::scale_lengths(body.shape, by.scale);
  ui::scale_elements(body.shape, by.scale);
  for (Support& support : body.supports) ui::scale_region(support.region, by.scale);
  for (Load& load : body.loads) ui::scale_region(load.region, by.scale);
  body.position += by.shift;
  return body;
}

Vec3 thickened_place(const BodyDescription& body, double factor, const Vec3& gravity, const Vec3& place) {
  const Stretch by = stretch_by(body, factor, gravity);
  const Pose pose = pose_of(body);
  return pose.to_world(pose.to_local(place).cwiseProduct(by.scale)) + by.shift;
}

}  // namespace griffith::app
