#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Spring with a damper between a point of a piece and a target, and the greatest force of both. All of it is relative
/// to the piece, so that pieces of any mass follow alike.
struct GrabSpring {
  double frequency = 3;        ///< frequency of the piece on the spring, ω = 2π f [Hz]; stiffness m ω²
  double damping_ratio = 0.7;  ///< ζ [-]; damping 2 ζ m ω
  double strength = 10;        ///< greatest force over the piece's weight under standard gravity [-]
  bool operator==(const GrabSpring&) const = default;
};

/// Grab of a point of material by a spring, as the mouse does it.
struct Grab {
  int tet = 0;                          ///< index of the tet with the point
  Vec3 weights = Vec3::Constant(0.25);  ///< barycentric weights of its corners 1 to 3; corner 0 has the rest to 1
  Vec3 target = Vec3::Zero();           ///< end of the spring [m]
  GrabSpring spring = {};
  bool operator==(const Grab&) const = default;
};

/// New target of the present grab.
struct GrabMove {
  Vec3 target = Vec3::Zero();  ///< [m]
  bool operator==(const GrabMove&) const = default;
};

/// End of the present grab.
struct GrabRelease {
  bool operator==(const GrabRelease&) const = default;
};

}  // namespace griffith
