#pragma once

#include "sim/core/lanes.h"
#include "sim/elasticity/material.h"

namespace griffith::shock {

using namespace simd;

/// Eight linear tetrahedra of one body. Displacements and gradients are seen from a reference placement near the
/// present one, so that single precision resolves the strains of stiff materials. Symmetric tensors have the entries
/// xx, yy, zz, xy, yz, xz.
struct ElementBlock {
  Lanes gradients[3][3];  ///< of the shape functions of corners 1 to 3 [1/m]
  Lanes volume;           ///< at rest [m³]; 0 in lanes without a tet
  Lanes stiffness;        ///< share of the law's: below 1 for slivers
  int nodes[4][kLanes];   ///< indices into the arrays of nodes
  Lanes offset[6];        ///< strain without stress [-]
  Lanes strain[6];        ///< elastic, times `stiffness`, as force_elements() saw it last, for its rate [-]
  Lanes rotation[4];      ///< quaternion x, y, z, w from the reference to now: of the corotational model alone
};

/// A body's law in the microsteps.
struct BlockLaw {
  ElementModel model = ElementModel::corotational;
  float lambda = 0, mu = 0;  ///< Lamé's constants [Pa]
  float viscosity = 0;       ///< Rayleigh's β over the length of a microstep [-]
};

/// What a block's viscosity takes: σ_j : ½ (ε_{j+1} − ε_{j−1}) in microstep j, with the viscous stress σ_j, so that it
/// takes two calls in a row to know.
struct ViscousWork {
  Lanes rate[6] = {};  ///< change of strain in the last call [-]
  Lanes work = {};     ///< so far [J]
};

/// The forces of eight tets on their corners [N], forces[4·lane + corner], and beside each force the largest principal
/// stress of its tet [Pa], 0 in compression: x, y, z, stress. Corotational strain follows its rotation by one Newton
/// step of the polar decomposition a call: exact for the small turns of a microstep.
///   displacements  of all nodes from their reference places [m]; the fourth number counts for nothing
///   work           gets that of the call before, which had the `viscosity` [-]
void force_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements, Quad* forces,
                    ViscousWork& work, float viscosity);

/// Work of the last call, σ_j : ½ (ε_j − ε_{j−1}): as far as it moved the block until then [J].
Lanes work_of_last(const BlockLaw& law, const ElementBlock& block, const ViscousWork& work);

/// Lets the rotations and strains of a block follow displacements however large, without forces. What is less stiff
/// than its law starts with the stress that it has under the law, by another `offset`; without stiffness, with none.
void settle_elements(const BlockLaw& law, ElementBlock& block, const WideQuad* displacements);

}  // namespace griffith::shock
