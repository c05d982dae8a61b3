#pragma once

#include <filesystem>
#include <variant>

#include "sim/core/linear_algebra.h"

namespace griffith {

// Residual stress of a body, as a strain without stress (eigenstrain): the strain that each element would have if it
// were cut free. All in the body's rest space.

/// Stress of tempered glass: σ(ζ) = σ_s (12 ζ² − 1)/2 in all directions normal to `normal`. ζ is the position along it
/// from the middle, over the thickness: σ_s at both surfaces, −σ_s/2 in the middle, no force in total. A wide free
/// plate has exactly this stress.
struct ParabolicStress {
  Vec3 normal = Vec3::UnitZ();   ///< any length but 0
  double surface_stress = -1e8;  ///< σ_s [Pa]; < 0 compresses the surfaces
  bool operator==(const ParabolicStress&) const = default;
};

/// The same strain everywhere, such as thermal strain αΔT. It causes stress only where supports hinder it.
struct UniformStrain {
  Vec3 strain = Vec3::Zero();  ///< along x, y, z [-]
  Vec3 shear = Vec3::Zero();   ///< components yz, xz, xy of the tensor [-]
  bool operator==(const UniformStrain&) const = default;
};

/// A strain for each tet, from a file: rows of the components xx, yy, zz, yz, xz, xy [-], in the order of the mesh.
struct StrainFile {
  std::filesystem::path path;  ///< as written in the scene; relative to the scene file's folder
  bool operator==(const StrainFile&) const = default;
};

using ResidualStress = std::variant<ParabolicStress, UniformStrain, StrainFile>;

}  // namespace griffith
