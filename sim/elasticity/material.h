#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace griffith {

/// Comparison of a node's separation tensor with the material's resistance.
enum class FractureCriterion {
  /// s = v⁺ / A(n̂) [Pa] against `tensile_strength`: independent of the mesh.
  strength,
  /// v⁺ [N] against `separation_toughness`, as published; depends on the element size.
  separation_force,
};

/// Strain measure of an element.
enum class ElementModel {
  /// Linear strain in the frame that rotates with the element (Müller & Gross 2004), for stiff and brittle materials.
  corotational,
  /// Green's strain (O'Brien & Hodgins 1999), which stiffens in large tension and softens in large compression.
  green_strain,
};

/// Isotropic elastic material, brittle unless it has a yield strength. SI units throughout.
struct Material {
  std::string name = "brick";
  double young_modulus = 15e9;        ///< E [Pa], > 0
  double poisson_ratio = 0.18;        ///< ν [-], 0 <= ν <= 0.495
  double density = 1900;              ///< ρ [kg/m³], > 0
  double tensile_strength = 2.5e6;    ///< σ_t [Pa], > 0
  double fracture_toughness = 0.7e6;  ///< K_Ic [Pa·√m], > 0: lowers the resistance at a crack front
  double separation_toughness = 1e6;  ///< τ [N], > 0: only used by FractureCriterion::separation_force
  FractureCriterion criterion = FractureCriterion::strength;
  ElementModel element_model = ElementModel::corotational;
  /// Compressive strength σ_c [Pa], >= σ_t: the stress state decides, by Drucker and Prager's surface through both
  /// strengths (equivalent_tension()); absent: the largest tension does (Rankine).
  std::optional<double> compressive_strength;
  std::optional<double> yield_strength;  ///< von Mises stress at which it yields [Pa], > 0; absent: never
  double plastic_limit = 0.25;           ///< largest norm of the plastic strain γ₂ [-], >= 0
  double friction = 0.6;                 ///< Coulomb's coefficient, >= 0
  double restitution = 0.1;              ///< coefficient of restitution, 0..1
  double mass_damping = 0.0;             ///< Rayleigh's α [1/s], >= 0
  double stiffness_damping = 1e-5;       ///< Rayleigh's β [s], >= 0

  bool operator==(const Material&) const = default;
};

/// Returns Lamé's λ = Eν/((1+ν)(1−2ν)) [Pa].
double lame_lambda(const Material& material);
/// Returns the shear modulus μ = E/(2(1+ν)) [Pa].
double shear_modulus(const Material& material);
/// Returns the speed of a longitudinal wave in a bar, √(E/ρ) [m/s].
double bar_wave_speed(const Material& material);

/// Typical material with the source of its values. A scatter of 30 % and more is normal.
struct MaterialPreset {
  std::string_view key;     ///< as in a scene file: "soda_lime_glass"
  std::string_view source;  ///< source of the values
  Material material;
};

/// Returns all presets, in the order of menus.
std::span<const MaterialPreset> material_presets();
/// Returns the preset with this key, if any.
std::optional<Material> find_material_preset(std::string_view key);

}  // namespace griffith
