#include <algorithm>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {

void MicrostepContacts::bond(int crack, int corner, const Bond& bond) {
  cracks_[crack].sides.bonds[corner] = bond;
  const auto place = std::ranges::lower_bound(bonded_, crack);
  if (place == bonded_.end() || *place != crack) bonded_.insert(place, crack);
}

/// Lets bonds resist the last motion.
void MicrostepContacts::hold_cracks(ExplicitBodies& bodies, double dt) {
  for (const int index : bonded_) {
    CrackSides& crack = cracks_[index].sides;
    for (int i = 0; i < 3; ++i)
      if (crack.bonds[i].holds())
        hold(bodies, bodies.corner(crack.first_slot, crack.first_corners[i]),
             bodies.corner(crack.second_slot, crack.second_corners[i]), crack.bonds[i], dt);
  }
  std::erase_if(bonded_, [&](int index) { return std::ranges::none_of(cracks_[index].sides.bonds, &Bond::holds); });
}

/// The impulse belongs to the forces before the last motion, part of which it takes back. The bond takes the energy of
/// its law; what the microstep's impulse takes more or less is a loss like that of contacts.
void MicrostepContacts::hold(ExplicitBodies& bodies, int first, int second, Bond& bond, double dt) {
  const Vec3 between = bodies.position(second) - bodies.position(first);
  const double opening = between.norm();
  if (opening <= bond.opening) return;
  const Vec3 direction = between / opening;
  const double mobility = bodies.mobility(first, direction) + bodies.mobility(second, direction);
  if (mobility == 0) return;
  const double energy = bond.energy_left();
  const Vec3 impulse = dt * pull(bond, opening, dt * dt * mobility) * direction;
  const double taken = energy - (bond.holds() ? bond.energy_left() : 0);
  const auto opening_speed = [&] { return Vec3(bodies.velocity(second) - bodies.velocity(first)); };
  const Vec3 before = opening_speed();
  const auto push = [&](int node, const Vec3& part) {
    const Vec3 velocity = bodies.velocity(node);
    push_node(bodies, node, part);
    shift_node(bodies, node, dt * (bodies.velocity(node) - velocity));
  };
  push(first, impulse);
  push(second, -impulse);
  fractured_ += taken;
  lost_ += 0.5 * impulse.dot(before + opening_speed()) - taken;
}

}  // namespace griffith::explicit_dynamics
