#pragma once

#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Weak planes relative to a direction of the material.
enum class WeaknessKind {
  grain,   ///< planes that contain the direction: wood splits along its fibers
  layers,  ///< planes normal to the direction: slate splits between its beds
};

/// Direction in which a body is weaker. A plane of unit normal n in rest space has the fraction n·T n of the material's
/// resistance. T is diagonal in axes along the direction: `strength_ratio` for the normals of weak planes, 1 for the
/// others. Under tension at an angle a to a grain this gives Hankinson's formula (1921), 1/σ = cos²a/σ_t +
/// sin²a/(ratio·σ_t).
struct Weakness {
  WeaknessKind kind = WeaknessKind::grain;
  Vec3 direction = Vec3::UnitX();  ///< in the body's rest space; any length but 0
  double strength_ratio = 0.1;  ///< resistance of the weakest direction over that of the strongest [-], 0 < ratio <= 1
  bool operator==(const Weakness&) const = default;
};

/// Tensor T of a Weakness in the world frame.
struct DirectionalStrength {
  Vec3 axis = Vec3::UnitX();  ///< unit length
  double along = 1;           ///< fraction of the resistance for planes with their normal along the axis
  double across = 1;          ///< fraction for normals across it

  bool is_uniform() const { return along == across; }
  double fraction(const Vec3& normal) const;  ///< Returns n·T n of a unit normal.
  Mat3 inverse_root() const;                  ///< Returns T^(−½).
};

/// `axis`: present direction of the weakness, unit length, world frame.
DirectionalStrength directional_strength(const Weakness& weakness, const Vec3& axis);

/// Flaws of random size (Weibull 1939). A volume V under the uniform tension s breaks with the probability 1 −
/// exp(−(V/V₀) (s Γ(1+1/m) / σ_t)^m). σ_t is therefore the mean strength of specimens of the volume V₀, and larger
/// bodies are weaker, independent of the mesh.
struct StrengthScatter {
  double weibull_modulus = 10;     ///< m [-], >= 1; glass and ceramics 5 to 20; smaller values scatter more
  double reference_volume = 1e-3;  ///< V₀ [m³], > 0
  int seed = 0;
  bool operator==(const StrengthScatter&) const = default;
};

/// Returns strength over σ_t of each node [-], drawn in the order of `volumes`, the nodes' parts of the body's volume
/// [m³].
std::vector<double> strength_factors(const StrengthScatter& scatter, const std::vector<double>& volumes);

}  // namespace griffith
