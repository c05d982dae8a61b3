#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace griffith {

/// How a node's separation tensor is compared with the material's resistance.
enum class FractureCriterion {
  /// s = v⁺ / A(n̂) [Pa] against `tensile_strength`: the same answer on every mesh.
  strength,
  /// v⁺ [N] against `separation_toughness`, as published; depends on the element size.
  separation_force,
};

/// Which strain an element measures.
enum class ElementModel {
  /// Linear strain in the frame that turns with the element (Müller & Gross 2004): for stiff and brittle materials.
  corotational,
  /// Green's strain (O'Brien & Hodgins 1999): stiffens in large stretch, softens in large compression.
  green_strain,
};

/// An isotropic elastic material, brittle unless it has a yield strength. SI units throughout.
struct Material {
  std::string name = "brick";
  double young_modulus = 15e9;        ///< E [Pa], > 0
  double poisson_ratio = 0.18;        ///< ν [-], 0 <= ν <= 0.495
  double density = 1900;              ///< ρ [kg/m³], > 0
  double tensile_strength = 2.5e6;    ///< σ_t [Pa], > 0
  double fracture_toughness = 0.7e6;  ///< K_Ic [Pa·√m], > 0: lowers the resistance at a crack front
  double separation_toughness = 1e6;  ///< τ [N], > 0: used by FractureCriterion::separation_force alone
  FractureCriterion criterion = FractureCriterion::strength;
  ElementModel element_model = ElementModel::corotational;
  std::optional<double> yield_strength;  ///< von Mises stress at which it flows [Pa], > 0; absent: it never does
  double plastic_limit = 0.25;           ///< largest norm of the plastic strain γ₂ [-], >= 0
  double friction = 0.6;                 ///< Coulomb's coefficient, >= 0
  double restitution = 0.1;              ///< coefficient of restitution, 0..1
  double mass_damping = 0.0;             ///< Rayleigh's α [1/s], >= 0
  double stiffness_damping = 1e-5;       ///< Rayleigh's β [s], >= 0

  bool operator==(const Material&) const = default;
};

/// Lamé's λ = Eν/((1+ν)(1−2ν)) [Pa].
double lame_lambda(const Material& material);
/// The shear modulus μ = E/(2(1+ν)) [Pa].
double shear_modulus(const Material& material);
/// The speed of a longitudinal wave in a bar, √(E/ρ) [m/s].
double bar_wave_speed(const Material& material);

/// A typical material with where its values come from; scatter of 30 % and more is normal.
struct MaterialPreset {
  std::string_view key;     ///< as in a scene file: "soda_lime_glass"
  std::string_view source;  ///< where the values come from
  Material material;
};

/// All presets, in the order in which menus show them.
std::span<const MaterialPreset> material_presets();
/// The preset with this key, or nothing.
std::optional<Material> find_material_preset(std::string_view key);

}  // namespace griffith
