#pragma once

#include "sim/world/frame.h"

namespace griffith::ui {

/// The energy that rounding alone may leave in the account of a frame [J], on the safe side: what all bodies gain over
/// a distance of `size` [m], the scene's, times the precision of numbers, and what they store under a strain of as
/// much.
double energy_noise(const Frame& frame, const Vec3& gravity, double size);

/// An entry of an account of energy, as it is shown.
struct EnergyShare {
  double energy = 0;    ///< [J]; 0 where it is rounding noise
  double fraction = 0;  ///< of all that was turned over, 0..1: the length of its bar
};
/// `whole`, `noise`: all that was turned over, and what rounding may leave [J].
EnergyShare energy_share(double energy, double whole, double noise);

}  // namespace griffith::ui
