#pragma once

#include "sim/elasticity/material.h"

namespace griffith {

/// Returns the resistance of a node: the tensile strength. At a crack front it is at most the stress that the mesh
/// shows at distance h from a crack at its critical load, c·K_Ic/√(2πh) (Irwin 1957; c = 1.3 measured on edge cracks of
/// 4 to 64 elements, ±20 %). With the force criterion it is the separation toughness [N].
///   element_size     h, local edge length [m]
///   strength_factor  fraction of the strength (or of τ) left by the node's flaws (strength_factors())
double resistance(const Material& material, bool at_crack_front, double element_size, double strength_factor = 1);

}  // namespace griffith
