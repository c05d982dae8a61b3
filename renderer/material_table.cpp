#include "renderer/material_table.h"

namespace griffith::render {
namespace {

constexpr int kMaterialFloats = 16;

/// Packs materials for the shader.
std::vector<float> packed(const std::vector<EmbeddedMaterial>& materials) {
  std::vector<float> values;
  values.reserve(kMaterialFloats * materials.size());
  for (const auto& [color, variation, mottle, roughness, noise_size, fiber, clear_depth, grain, grain_size, dressed,
                    gloss, blur, metal] : materials)
    values.insert(values.end(),
                  {color.r, color.g, color.b, variation, mottle, roughness, noise_size, fiber.x(), fiber.y(), fiber.z(),
                   clear_depth, static_cast<float>(grain), grain_size, gloss, blur, metal});
  return values;
}

}  // namespace

void MaterialTable::upload(const std::vector<EmbeddedMaterial>& materials) { values_.upload(packed(materials)); }

}  // namespace griffith::render
