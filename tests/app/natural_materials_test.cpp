#include "app/picture/natural_materials.h"

#include <gtest/gtest.h>

#include <string>

namespace griffith::app {
namespace {

Material named(const std::string& name) {
  Material material = find_material_preset("rubber").value();
  material.name = name;
  return material;
}

TEST(NaturalMaterials, EachPresetLooksLikeItself) {
  for (const MaterialPreset& preset : material_presets()) {
    const std::string_view alike = preset_alike(preset.material);
    if (preset.key.starts_with("wood"))
      EXPECT_TRUE(alike.starts_with("wood"));
    else
      EXPECT_EQ(alike, preset.key);
  }
}

TEST(NaturalMaterials, WordsOfANameTellTheLook) {
  EXPECT_EQ(preset_alike(named("soft Porcelain")), "porcelain");
  EXPECT_EQ(preset_alike(named("brickwork")), "brick");
  EXPECT_EQ(preset_alike(named("toughened glass, 6 mm")), "soda_lime_glass");
  EXPECT_EQ(preset_alike(named("terracotta")), "brick");
  for (const char* nothing : {"", "device", "licensed 3", "7"}) EXPECT_EQ(preset_alike(named(nothing)), "rubber");
}

TEST(NaturalMaterials, WithoutAWordDensityReportsItHoweverSoftTheMaterialIs) {
  for (const char* key : {"brick", "granite", "marble", "plaster", "ice", "mild_steel"}) {
    Material material = find_material_preset(key).value();
    material.name = "1";
    material.young_modulus /= 20;
    EXPECT_EQ(preset_alike(material), key);
  }
}

TEST(NaturalMaterials, PanesAreFlatOutsideSoThatTheyMirrorLampsWithEvenEdges) {
  for (const char* key : {"soda_lime_glass", "acrylic", "ice"}) {
    Scene scene;
    scene.bodies.resize(1);
    scene.bodies[0].material = find_material_preset(key).value();
    const auto looks = natural_materials(scene);
    EXPECT_LT(looks[look_index(0, Look::outside)].roughness, 0.01) << key;
    EXPECT_GT(looks[look_index(0, Look::inside)].roughness, 0.05) << key;
  }
}

TEST(NaturalMaterials, GlazeLiesOnTheOutsideAlone) {
  Scene scene;
  scene.bodies.resize(1);
  for (const char* key : {"porcelain", "marble"}) {
    scene.bodies[0].material = find_material_preset(key).value();
    const std::vector<render::EmbeddedMaterial> looks = natural_materials(scene);
    EXPECT_GT(looks[look_index(0, Look::outside)].gloss, 0) << key;
    EXPECT_EQ(looks[look_index(0, Look::inside)].gloss, 0) << key;
  }
}

}  // namespace
}  // namespace griffith::app
