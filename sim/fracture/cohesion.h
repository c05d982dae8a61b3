#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "sim/fracture/crack_front.h"

namespace griffith {

/// Cohesion of the part of an opened face that belongs to one of its corners. Its force falls linearly with the largest
/// opening so far, from that at which the face opened to 0 (extrinsic law, Camacho & Ortiz 1996; continuous in time,
/// Papoulia, Sam & Vavasis 2003). It acts against further opening alone, in any mode, and never pushes back: what it
/// has taken, the area of the crack times G_c in the end, is spent.
struct Bond {
  double force = 0;     ///< at no opening [N]; 0: the corner is not open yet, or the bond is broken
  double critical = 0;  ///< opening at which it breaks, δ_c = 2 G_c / t₀ [m]; infinite: the corner is not open yet
  double opening = 0;   ///< largest so far [m]

  bool holds() const { return force > 0; }
  bool is_closed() const { return std::isinf(critical); }
  static constexpr Bond closed() { return {0, std::numeric_limits<double>::infinity(), 0}; }
  /// Returns the force at its largest opening, the most that it bears [N].
  double strength() const { return force * (1 - opening / critical); }
  /// Returns the part of its energy that it has not taken, 1 of a closed corner.
  double untaken() const {
    const double left = 1 - opening / critical;
    return holds() || is_closed() ? left * left : 0;
  }
  /// Returns the energy that it can still take, ½ F δ_c (1 − δ/δ_c)² [J].
  double energy_left() const;
};

/// Returns the force of a bond at its opening now, which acts on a motion of its ends apart to `opening` [m] [N]. Each
/// newton takes back `compliance` of that [m/N], > 0; no more is taken back than stops it. Updates the bond, which
/// breaks in the motion that uses up its energy. By a leapfrog scheme the force works over half of the motion before
/// and half of that after it; the sum over all motions is the bond's energy to second order.
double pull(Bond& bond, double opening, double compliance);

/// Returns the force that takes this energy if it is constant over the way from the largest opening so far to `opening`
/// [m]: the strength of a bond that does not open, less the farther it does [N].
double mean_force(const Bond& bond, double opening);
/// Records that a bond has opened as far as `opening` [m]. Returns the energy that it took [J].
double open(Bond& bond, double opening);

/// Opened face that still holds, or that ends at a front.
struct CohesiveFace {
  OpenFace face;
  std::array<Bond, 3> bonds;  ///< by corner of the face
};

}  // namespace griffith
