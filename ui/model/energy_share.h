#pragma once

#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Upper estimate of the energy that rounding alone leaves in the account of a frame [J]: the relative precision of
/// sums times the work of gravity on all bodies over `size` [m], the extent of the scene, plus the energy that they
/// store at a strain of that precision.
double energy_noise(const Frame& frame, const Vec3& gravity, double size);

/// An entry of an energy account, as shown.
struct EnergyShare {
  double energy = 0;    ///< [J]; 0 if it is rounding noise
  double fraction = 0;  ///< fraction of the total turnover, 0..1: the length of its bar
};
/// Returns the shown entry. `whole`, `noise`: total turnover and upper estimate of rounding noise [J].
EnergyShare energy_share(double energy, double whole, double noise);

}  // namespace griffith::ui
