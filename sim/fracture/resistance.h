#pragma once

#include "sim/elasticity/material.h"

namespace griffith {

/// Returns the resistance of a node by its material's fracture law: the tensile strength [Pa], or a force [N].
///   strength_factor  fraction of the strength (or of τ) left by the node's flaws (strength_factors())
double resistance(const Material& material, double strength_factor = 1);

/// Returns the least stress at a node at which it may separate: its resistance; at a crack front at most the stress of
/// an element beside a crack at its critical load, c·K_Ic/√(2πh) (Irwin 1957). It screens nodes; c = 0.65 is below what
/// any pattern of tets shows.
///   element_size  h, local edge length [m]
double screening_resistance(const Material& material, bool at_crack_front, double element_size,
                            double strength_factor = 1);

/// Returns the energy that a crack takes per area, both of its faces together: G_c = K_Ic² (1 − ν²) / E (Irwin 1957)
/// [J/m²].
///   strength_fraction  fraction of the material's K_Ic across the plane of the crack
double fracture_energy(const Material& material, double strength_fraction = 1);

/// Returns l_ch = (K_Ic/σ_t)² [m]: a crack of about this length halves the strength of a body (Irwin 1957).
double characteristic_length(const Material& material);

}  // namespace griffith
