#pragma once

#include <array>

#include "sim/fracture/crack_front.h"

namespace griffith {

/// Cohesion of the part of an opened face that belongs to one of its corners. Its force falls linearly with the largest
/// opening so far, from that at which the face opened to 0 (extrinsic law, Camacho & Ortiz 1996; continuous in time,
/// Papoulia, Sam & Vavasis 2003), in any mode. Below the largest opening it is elastic: its force falls in proportion
/// to the opening. Once broken, it has taken its share of the area times G_c.
struct Bond {
  double force = 0;     ///< at no opening [N]; 0: the corner is not open, or the bond is broken
  double critical = 0;  ///< opening at which it breaks, δ_c = 2 G_c / t₀ [m]
  double opening = 0;   ///< largest so far [m]
  double now = 0;       ///< present opening, 0 ≤ δ ≤ `opening` [m]

  bool holds() const { return force > 0; }
  /// Returns the force at its largest opening [N].
  double held() const { return force * (1 - opening / critical); }
  /// Returns the energy that it can still take before it breaks [J].
  double energy_left() const;
};

/// Returns the force of a bond on ends that have moved to the distance `apart` [m] from each other [N]. Each newton
/// takes back `compliance` of that [m/N], > 0. Updates the bond, which breaks in the motion that uses up its energy.
/// Softening is explicit: by a leapfrog scheme the force works over half of the motion before and half of that after
/// it; the sum over all motions is the bond's energy to second order. Elastic motions, which can be stiff, are
/// implicit.
double pull(Bond& bond, double apart, double compliance);

/// Opened face that still holds.
struct CohesiveFace {
  OpenFace face;
  std::array<Bond, 3> bonds;  ///< by corner of the face
};

}  // namespace griffith
