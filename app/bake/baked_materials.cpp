#include "app/bake/baked_materials.h"

#include <cmath>

#include "app/picture/natural_materials.h"

namespace griffith::app {
namespace {

/// Converts sRGB to linear (IEC 61966-2-1).
double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// Converts a material: clear ones transmit two thirds of the light and are polished; others are as rough as they are
/// uneven.
BakedMaterial baked(const render::EmbeddedMaterial& material, const std::string& name) {
  const bool is_clear = material.clear_depth > 0;
  const render::Rgb color = material.color;
  return {name, Vec3(linear(color.r), linear(color.g), linear(color.b)), is_clear ? 1.0 / 3 : 1.0,
          is_clear ? 0.05 : std::min(1.0, 0.4 + 2 * double(material.roughness))};
}

bool has_mortar(const BodyDescription& body) {
  const auto* bricks = body.splinters ? std::get_if<BrickSplinters>(&*body.splinters) : nullptr;
  return bricks && bricks->mortar > 0;
}

}  // namespace

BakedMaterials baked_materials(const Scene& scene, std::span<const std::string> stems) {
  const std::vector<render::EmbeddedMaterial> looks = natural_materials(scene);
  BakedMaterials materials;
  const auto add = [&](BakedMaterial material) {
    materials.all.push_back(std::move(material));
    return static_cast<int>(materials.all.size()) - 1;
  };
  for (int body = 0; body < std::ssize(scene.bodies); ++body) {
    const int outside = add(baked(looks[look_index(body, Look::outside)], stems[body] + "_outside"));
    const int inside = add(baked(looks[look_index(body, Look::inside)], stems[body] + "_inside"));
    const bool mortar = has_mortar(scene.bodies[body]);
    materials.of_body.push_back(
        {outside, inside,
         mortar ? add(baked(looks[look_index(body, Look::mortar)], stems[body] + "_mortar")) : inside});
  }
  materials.projectile = add({stems.back(), Vec3::Constant(0.05), 1, 0.4});
  return materials;
}

}  // namespace griffith::app
