#include <algorithm>
#include <array>
#include <cmath>

#include "sim/elasticity/material.h"

namespace griffith {
namespace {

constexpr std::string_view kAshby = "Ashby, Materials Selection in Mechanical Design (2011), typical values";
constexpr std::string_view kIce = "Schulson & Duval, Creep and Fracture of Ice (2009), typical values";
constexpr std::string_view kHandbook = "typical handbook value";

/// Properties of a preset. `toughness`: K_Ic [Pa·√m].
struct Elastic {
  double young_modulus, poisson_ratio, density;
};
struct Brittle {
  double tensile_strength, toughness;
};
struct Surface {
  double friction, restitution;
};

MaterialPreset preset(std::string_view key, std::string name, Elastic elastic, Brittle brittle, Surface surface,
                      std::string_view source) {
  Material m;
  m.name = std::move(name);
  m.young_modulus = elastic.young_modulus;
  m.poisson_ratio = elastic.poisson_ratio;
  m.density = elastic.density;
  m.tensile_strength = brittle.tensile_strength;
  m.fracture_toughness = brittle.toughness;
  // The force on a node at the tensile strength grows with the area around it. Elements of some 0.6 m are assumed.
  m.separation_toughness = 0.4 * brittle.tensile_strength;
  m.friction = surface.friction;
  m.restitution = surface.restitution;
  return {key, source, m};
}

/// Returns K_Ic = √(G_c E / (1−ν²)) [Pa·√m] from the energy release rate G_c [J/m²], plane strain (Irwin 1957).
double toughness_from_energy(double release_rate, Elastic elastic) {
  return std::sqrt(release_rate * elastic.young_modulus / (1 - elastic.poisson_ratio * elastic.poisson_ratio));
}

MaterialPreset yielding(double yield_strength, MaterialPreset ductile) {
  ductile.material.yield_strength = yield_strength;
  return ductile;
}

std::array<MaterialPreset, 17> make_presets() {
  const Elastic rubber{2e6, 0.49, 930}, jelly{1e4, 0.49, 1010};
  return {{
      preset("soda_lime_glass", "soda-lime glass", {70e9, 0.22, 2500}, {45e6, 0.76e6}, {0.4, 0.5}, kAshby),
      preset("concrete", "concrete", {30e9, 0.20, 2400}, {3e6, 1.2e6}, {0.7, 0.1}, kAshby),
      preset("brick", "brick", {15e9, 0.18, 1900}, {2.5e6, 0.7e6}, {0.6, 0.1}, kAshby),
      preset("porcelain", "porcelain", {70e9, 0.20, 2400}, {50e6, 1.2e6}, {0.4, 0.4}, kHandbook),
      preset("alumina", "alumina", {370e9, 0.22, 3900}, {250e6, 4.0e6}, {0.4, 0.5}, kAshby),
      preset("ice", "ice", {9e9, 0.33, 917}, {1e6, 0.1e6}, {0.05, 0.3}, kIce),
      preset("granite", "granite", {60e9, 0.25, 2650}, {10e6, 0.9e6}, {0.6, 0.3}, kHandbook),
      preset("marble", "marble", {55e9, 0.27, 2730}, {8e6, 0.9e6}, {0.5, 0.3}, kAshby),
      preset("plaster", "plaster", {4.5e9, 0.20, 1100}, {2e6, 0.15e6}, {0.7, 0.1}, kHandbook),
      preset("wood_along_grain", "wood, along the grain", {11e9, 0.35, 500}, {90e6, 7e6}, {0.5, 0.3}, kAshby),
      preset("wood_across_grain", "wood, across the grain", {0.6e9, 0.30, 500}, {3e6, 0.4e6}, {0.5, 0.3}, kAshby),
      preset("abs", "ABS", {2.2e9, 0.37, 1040}, {42e6, 3.0e6}, {0.4, 0.4}, kAshby),
      preset("acrylic", "acrylic", {3.0e9, 0.37, 1190}, {65e6, 1.4e6}, {0.4, 0.4}, kAshby),
      preset("grey_cast_iron", "gray cast iron", {110e9, 0.26, 7200}, {200e6, 15e6}, {0.4, 0.3}, kHandbook),
      yielding(250e6, preset("mild_steel", "mild steel", {205e9, 0.29, 7850}, {450e6, 100e6}, {0.5, 0.4}, kHandbook)),
      preset("rubber", "rubber", rubber, {20e6, toughness_from_energy(1e4, rubber)}, {0.9, 0.6},
             "typical handbook value; fracture toughness from 1e4 J/m²"),
      preset("jelly", "jelly", jelly, {1e4, toughness_from_energy(3, jelly)}, {0.4, 0.2},
             "typical value of gelatine gels; fracture toughness from 3 J/m²"),
  }};
}

}  // namespace

std::span<const MaterialPreset> material_presets() {
  static const std::array<MaterialPreset, 17> kPresets = make_presets();
  return kPresets;
}

std::optional<Material> find_material_preset(std::string_view key) {
  const auto found = std::ranges::find(material_presets(), key, &MaterialPreset::key);
  if (found == material_presets().end()) return std::nullopt;
  return found->material;
}

}  // namespace griffith
