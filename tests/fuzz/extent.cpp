#include "tests/fuzz/extent.h"

#include <type_traits>

namespace griffith::fuzz {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

Vec3 element_size_of(const Shape& shape) {
  const auto swept = [](const auto& of) { return Vec3(of.element_size.x(), of.element_size.x(), of.element_size.y()); };
  return std::visit(Overloaded{
                        [](const BoxShape& box) { return box.element_size; },
                        [&](const CylinderShape& cylinder) { return swept(cylinder); },
                        [&](const DiscShape& disc) { return swept(disc); },
                        [](const SphereShape& sphere) { return Vec3(Vec3::Constant(sphere.element_size)); },
                        [&](const PlateWithHoleShape& plate) { return swept(plate); },
                        [](const NotchedBeamShape& beam) { return beam.element_size; },
                        [](const MeshFileShape& mesh) { return Vec3(Vec3::Constant(mesh.scale)); },
                        [](const SurfaceShape& surface) {
                          return Vec3(Vec3::Constant(surface.meshing.element_size.value_or(0.09 * surface.scale)));
                        },
                    },
                    shape);
}

}  // namespace

Vec3 extent_of(const Shape& shape) {
  return std::visit(Overloaded{
                        [](const BoxShape& box) { return box.size; },
                        [](const CylinderShape& of) { return Vec3(2 * of.radius, 2 * of.radius, of.length); },
                        [](const DiscShape& of) { return Vec3(2 * of.radius, 2 * of.radius, of.thickness); },
                        [](const SphereShape& of) { return Vec3(Vec3::Constant(2 * of.radius)); },
                        [](const PlateWithHoleShape& plate) { return plate.size; },
                        [](const NotchedBeamShape& beam) { return beam.size; },
                        [](const auto& file) { return Vec3(Vec3::Constant(file.scale)); },
                    },
                    shape);
}

double cells_of(const Shape& shape) {
  return (extent_of(shape).array() / element_size_of(shape).array()).round().max(1).prod();
}

double finest_edge_of(const Shape& shape) { return element_size_of(shape).cwiseMin(extent_of(shape)).minCoeff(); }

void coarsen(Shape& shape) {
  const Vec3 half = extent_of(shape) / 2;
  std::visit(Overloaded{
                 [&](BoxShape& box) { box.element_size = half; },
                 [&](SphereShape& sphere) { sphere.element_size = sphere.radius; },
                 [&](NotchedBeamShape& beam) { beam.element_size = half; },
                 [](MeshFileShape& mesh) { mesh.path = "box.msh"; },
                 [](SurfaceShape& surface) {
                   surface.path = "box.off";
                   surface.meshing.method = MeshingMethod::volumetric;
                   surface.meshing.element_size = surface.scale / 2;
                 },
                 [&](auto& swept) { swept.element_size = Vec2(half.x(), half.z()); },
             },
             shape);
}

}  // namespace griffith::fuzz
