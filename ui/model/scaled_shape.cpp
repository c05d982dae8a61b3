#include "ui/model/scaled_shape.h"

#include <cmath>
#include <type_traits>

namespace griffith::ui {
namespace {

/// True if a shape has equal cross sections along its own z axis.
template <class T>
constexpr bool is_round =
    std::is_same_v<T, CylinderShape> || std::is_same_v<T, DiscShape> || std::is_same_v<T, PlateWithHoleShape>;

Vec3 extents(const BoxShape& box) { return box.size; }
Vec3 extents(const CylinderShape& cylinder) { return {2 * cylinder.radius, 2 * cylinder.radius, cylinder.length}; }
Vec3 extents(const DiscShape& disc) { return {2 * disc.radius, 2 * disc.radius, disc.thickness}; }
Vec3 extents(const SphereShape& sphere) { return Vec3::Constant(2 * sphere.radius); }
Vec3 extents(const PlateWithHoleShape& plate) { return plate.size; }
Vec3 extents(const NotchedBeamShape& beam) { return beam.size; }

void lengthen(BoxShape& box, const Vec3& factors) { box.size = scaled(box.size, factors); }
void lengthen(CylinderShape& cylinder, const Vec3& factors) {
  cylinder.radius = scaled(cylinder.radius, factors.x());
  cylinder.length = scaled(cylinder.length, factors.z());
}
void lengthen(DiscShape& disc, const Vec3& factors) {
  disc.radius = scaled(disc.radius, factors.x());
  disc.thickness = scaled(disc.thickness, factors.z());
}
void lengthen(SphereShape& sphere, const Vec3& factors) { sphere.radius = scaled(sphere.radius, factors.x()); }
void lengthen(PlateWithHoleShape& plate, const Vec3& factors) {
  plate.size = scaled(plate.size, factors);
  plate.hole_radius = scaled(plate.hole_radius, factors.x());
}
void lengthen(NotchedBeamShape& beam, const Vec3& factors) {
  beam.size = scaled(beam.size, factors);
  beam.notch_depth = scaled(beam.notch_depth, factors.y());
}
void lengthen(MeshFileShape& mesh, const Vec3& factors) { mesh.scale = scaled(mesh.scale, factors.x()); }
void lengthen(SurfaceShape& surface, const Vec3& factors) { surface.scale = scaled(surface.scale, factors.x()); }

}  // namespace

double scaled(double value, double factor) {
  constexpr int kDigits = 12;
  if (value == 0 || factor == 1) return value * factor;
  const double exact = value * factor;
  const double parts = std::pow(10, kDigits - std::ceil(std::log10(std::abs(exact))));
  return std::round(exact * parts) / parts;
}

Vec3 scaled(const Vec3& value, const Vec3& factors) {
  return value.binaryExpr(factors, [](double a, double b) { return scaled(a, b); });
}

ScaleGroups scale_groups(const Shape& shape) {
  return std::visit(
      []<class T>(const T&) -> ScaleGroups {
        if (std::is_same_v<T, BoxShape> || std::is_same_v<T, NotchedBeamShape>) return {0, 1, 2};
        return is_round<T> ? ScaleGroups{0, 0, 2} : ScaleGroups{0, 0, 0};
      },
      shape);
}

std::optional<Vec3> extents_of(const Shape& shape) {
  return std::visit(
      [](const auto& known) -> std::optional<Vec3> {
        if constexpr (requires { extents(known); }) return extents(known);
        return std::nullopt;
      },
      shape);
}

void scale_lengths(Shape& shape, const Vec3& factors) {
  std::visit([&](auto& known) { lengthen(known, factors); }, shape);
}

void scale_elements(Shape& shape, const Vec3& factors) {
  std::visit(
      [&](auto& known) {
        if constexpr (requires { known.element_size; }) {
          using Size = std::decay_t<decltype(known.element_size)>;
          if constexpr (std::is_same_v<Size, Vec3>) known.element_size = scaled(known.element_size, factors);
          if constexpr (std::is_same_v<Size, double>) known.element_size = scaled(known.element_size, factors.x());
          if constexpr (std::is_same_v<Size, Vec2>)
            known.element_size = {scaled(known.element_size.x(), factors.x()),
                                  scaled(known.element_size.y(), factors.z())};
        }
      },
      shape);
}

void scale_region(Region& region, const Vec3& factors) {
  if (auto* box = std::get_if<BoxRegion>(&region)) {
    box->minimum = scaled(box->minimum, factors);
    box->maximum = scaled(box->maximum, factors);
  } else if (auto* sphere = std::get_if<SphereRegion>(&region)) {
    sphere->center = scaled(sphere->center, factors);
    if (factors == Vec3::Constant(factors.x())) sphere->radius = scaled(sphere->radius, factors.x());
  } else if (auto* half = std::get_if<HalfSpaceRegion>(&region)) {
    half->point = scaled(half->point, factors);
    half->normal = half->normal.cwiseQuotient(factors);
  }
}

}  // namespace griffith::ui
