#pragma once

// Private to sim/contact: sweeps over the contacts of a group, which find the impulses of a substep.

#include <limits>
#include <span>

#include "sim/contact/rigid_rows.h"

namespace griffith::contact {

/// Changes the motions of bodies together with the impulses of their contacts.
class RigidSweeps {
 public:
  /// Both must outlive this.
  RigidSweeps(std::span<Motion> motions, RigidRows& rows) : motions_(motions), rows_(rows) {}

  /// Returns the derivative of the energy of motion by a common factor of all impulses [J].
  double power_of_impulses() const;

  /// Multiplies all impulses by `share`.
  void scale_impulses(double share);

  /// Sweeps until a sweep changes no normal velocity by more than `tolerance` [m/s], or has taken too much work: less
  /// where impulses are remembered than where all of them must be found (`is_cold`). Returns the sweeps.
  int solve(double tolerance, bool is_cold);

  /// Largest change of a normal velocity by the last sweep of solve(); infinite if it was not measured [m/s].
  double last_change() const { return last_change_; }

  /// Solves all contacts once, in sequence. Returns the largest change of a normal velocity [m/s].
  double sweep();

 private:
  void push_sides(const Block& block, const Point& point, const Triple& along_axes);
  double extrapolate(double last_size);
  double relax(const Block& block);

  std::span<Motion> motions_;
  RigidRows& rows_;
  double last_change_ = std::numeric_limits<double>::infinity();
};

}  // namespace griffith::contact
