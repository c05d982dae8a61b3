#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

#include "sim/elasticity/material.h"

namespace griffith {
namespace {

TEST(MaterialPresets, TheDefaultMaterialIsBrick) { EXPECT_EQ(find_material_preset("brick"), Material{}); }

TEST(MaterialPresets, UnknownKeysFindNothing) {
  EXPECT_FALSE(find_material_preset("unobtainium"));
  EXPECT_FALSE(find_material_preset(""));
}

TEST(MaterialPresets, EveryOneIsPhysicalNamedAndSourced) {
  std::set<std::string_view> keys, names;
  for (const MaterialPreset& preset : material_presets()) {
    SCOPED_TRACE(preset.key);
    const Material& m = preset.material;
    EXPECT_TRUE(std::regex_match(std::string(preset.key), std::regex("[a-z]+(_[a-z]+)*")));
    EXPECT_TRUE(keys.insert(preset.key).second);
    EXPECT_TRUE(names.insert(m.name).second);
    EXPECT_FALSE(preset.source.empty());
    EXPECT_EQ(find_material_preset(preset.key), m);
    EXPECT_GT(lame_lambda(m), 0);
    EXPECT_TRUE(m.restitution >= 0 && m.restitution <= 1);
    EXPECT_GT(m.friction, 0);
    // Sound travels at meters per second in rubbery gels, at some ten kilometers per second in ceramics.
    EXPECT_TRUE(bar_wave_speed(m) > 1 && bar_wave_speed(m) < 12000) << bar_wave_speed(m);
  }
  EXPECT_EQ(keys.size(), 17u);
}

TEST(MaterialPresets, SoftOnesTakeTheEnergyToTearThem) {
  const auto release_rate = [](const char* key) {
    const Material m = *find_material_preset(key);
    return m.fracture_toughness * m.fracture_toughness * (1 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
  };
  EXPECT_NEAR(release_rate("rubber"), 1e4, 1e-6);
  EXPECT_NEAR(release_rate("jelly"), 3, 1e-9);
}

}  // namespace
}  // namespace griffith
