#include <algorithm>

#include "sim/shock/impacts.h"

namespace griffith::shock {

void Impacts::bond(int crack, int corner, const Bond& bond) {
  cracks_[crack].sides.bonds[corner] = bond;
  const auto place = std::ranges::lower_bound(bonded_, crack);
  if (place == bonded_.end() || *place != crack) bonded_.insert(place, crack);
}

/// Lets bonds resist the last motion.
void Impacts::hold_cracks(Solid& solid, double dt) {
  for (const int index : bonded_) {
    CrackSides& crack = cracks_[index].sides;
    for (int i = 0; i < 3; ++i)
      if (crack.bonds[i].holds())
        hold(solid, solid.corner(crack.first_slot, crack.first_corners[i]),
             solid.corner(crack.second_slot, crack.second_corners[i]), crack.bonds[i], dt);
  }
  std::erase_if(bonded_, [&](int index) { return std::ranges::none_of(cracks_[index].sides.bonds, &Bond::holds); });
}

/// The impulse belongs to the forces before the last motion, part of which it takes back. The bond takes the energy of
/// its law; what the microstep's impulse takes more or less is a loss like that of contacts.
void Impacts::hold(Solid& solid, int first, int second, Bond& bond, double dt) {
  const Vec3 between = solid.position(second) - solid.position(first);
  const double opening = between.norm();
  if (opening <= bond.opening) return;
  const Vec3 direction = between / opening;
  const double mobility = solid.mobility(first, direction) + solid.mobility(second, direction);
  if (mobility == 0) return;
  const double energy = bond.energy_left();
  const Vec3 impulse = dt * pull(bond, opening, dt * dt * mobility) * direction;
  const double taken = energy - (bond.holds() ? bond.energy_left() : 0);
  const auto opening_speed = [&] { return Vec3(solid.velocity(second) - solid.velocity(first)); };
  const Vec3 before = opening_speed();
  const auto push = [&](int node, const Vec3& part) {
    const Vec3 velocity = solid.velocity(node);
    push_node(solid, node, part);
    shift_node(solid, node, dt * (solid.velocity(node) - velocity));
  };
  push(first, impulse);
  push(second, -impulse);
  fractured_ += taken;
  lost_ += 0.5 * impulse.dot(before + opening_speed()) - taken;
}

}  // namespace griffith::shock
