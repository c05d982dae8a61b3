#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/material.h"

namespace griffith::explicit_dynamics {

using namespace simd;

/// Eight linear tetrahedra of one body. Displacements and gradients are relative to a reference placement near the
/// present one, so that single precision resolves the strains of stiff materials. Symmetric tensors have the entries
/// xx, yy, zz, xy, yz, xz.
struct ElementBlock {
  Lanes gradients[3][3];  ///< gradients of the shape functions of corners 1 to 3 [1/m]
  Lanes volume;           ///< volume at rest [m³]; 0 in lanes without a tet
  Lanes stiffness;        ///< fraction of the law's stiffness: below 1 for slivers
  int nodes[4][kLanes];   ///< indices into the arrays of nodes
  Lanes offset[6];        ///< stress-free strain [-]
  Lanes strain[6];        ///< elastic strain times `stiffness` in the last force_elements(), for its rate [-]
  Lanes rotation[4];      ///< quaternion x, y, z, w from the reference to the present; only for the corotational model
};

/// Law of a body in the microsteps.
struct BlockLaw {
  ElementModel model = ElementModel::corotational;
  float lambda = 0, mu = 0;  ///< Lamé's constants [Pa]
  float viscosity = 0;       ///< Rayleigh's β over the duration of a microstep [-]
  /// Tensile over compressive strength of the strength surface [-]; 0: the material has none.
  float strength_ratio = 0;
};

/// Work dissipated by a block's viscosity: σ_j : ½ (ε_{j+1} − ε_{j−1}) in microstep j, with the viscous stress σ_j. It
/// is known after two consecutive calls.
struct ViscousWork {
  Lanes rate[6] = {};  ///< change of strain in the last call [-]
  Lanes work = {};     ///< total work [J]
};

/// Computes the forces of eight tets on their corners [N], forces[4·lane + corner], as x, y, z and, in the fourth lane,
/// the largest principal stress of the tet [Pa], 0 in compression, or its equivalent tension if larger. Corotational
/// strain follows its rotation by one Newton step of the polar decomposition per call, exact for the small rotations of
/// a microstep.
///   displacements  displacements of all nodes from their reference positions [m]; the fourth lane is meaningless
///   work           receives that of the preceding call, with the `viscosity` [-]
///   finds_largest  if false, the fourth lane is 0
void force_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements, Quad* forces,
                    ViscousWork& work, float viscosity, bool finds_largest);

/// Returns the work of the last call, σ_j : ½ (ε_j − ε_{j−1}), for the motion up to it [J].
Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const ViscousWork& work);

/// Updates rotations and strains of a block for displacements of any size, without forces. Elements of reduced
/// stiffness start with their stress under the full law, by another `offset`; those without stiffness start without
/// stress.
void settle_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements);

}  // namespace griffith::explicit_dynamics
