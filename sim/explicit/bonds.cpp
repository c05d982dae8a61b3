#include <algorithm>
#include <utility>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {
namespace {

/// Returns how many sixteenths of its critical opening a bond has passed.
int opened_parts(const Bond& bond) {
  constexpr int kParts = 16;
  return bond.holds() ? static_cast<int>(kParts * bond.opening / bond.critical) : kParts;
}

}  // namespace

/// Lists the bonds that hold, those between the same nodes in sequence.
void MicrostepContacts::list_bonds(const ExplicitBodies& bodies) {
  bonds_.clear();
  for (int index = 0; index < crack_count(); ++index) {
    const CrackSides& crack = cracks_[index].sides;
    for (int i = 0; i < 3; ++i) {
      if (!crack.bonds[i].holds()) continue;
      const int first = bodies.corner(crack.first_slot, crack.first_corners[i]),
                second = bodies.corner(crack.second_slot, crack.second_corners[i]);
      bonds_.push_back({std::min(first, second), std::max(first, second), index, i});
    }
  }
  std::ranges::stable_sort(bonds_, {}, [](const BondedCorner& bond) { return std::pair(bond.first, bond.second); });
  lists_bonds_ = true;
}

/// Ties the copies of edges along cracks until both of their ends have broken: bonds act at corners, and between these
/// the sides of a crack open linearly. An edge that were free at once would open by itself, for nothing.
void MicrostepContacts::tie_edges(ExplicitBodies& bodies) {
  if (!bodies.has_edges()) return;
  std::vector<std::pair<int, int>> pairs;
  for (const WatchedCrack& watched : cracks_) {
    const CrackSides& crack = watched.sides;
    if (!bodies.is_quadratic(bodies.body_of_slot(crack.first_slot))) continue;
    const auto is_broken = [&](int i) {
      return !crack.bonds[i].holds() && bodies.corner(crack.first_slot, crack.first_corners[i]) !=
                                            bodies.corner(crack.second_slot, crack.second_corners[i]);
    };
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      if (is_broken(i) && is_broken(next)) continue;
      const int first = bodies.edge_between(crack.first_slot, crack.first_corners[i], crack.first_corners[next]),
                second = bodies.edge_between(crack.second_slot, crack.second_corners[i], crack.second_corners[next]);
      if (first != second) pairs.emplace_back(first, second);
    }
  }
  lost_ += bodies.tie_edges(pairs);
}

/// Lets bonds resist the last motion. Those between two nodes began when these came apart and have opened alike: they
/// act as one.
void MicrostepContacts::hold_cracks(ExplicitBodies& bodies, double dt) {
  if (!lists_bonds_) list_bonds(bodies);
  have_bonds_opened_ = false;
  const auto bond_at = [&](const BondedCorner& at) -> Bond& { return cracks_[at.crack].sides.bonds[at.corner]; };
  for (auto first = bonds_.begin(); first != bonds_.end();) {
    const auto last = std::find_if(first, bonds_.end(), [&](const BondedCorner& other) {
      return other.first != first->first || other.second != first->second;
    });
    Bond whole = bond_at(*first);
    for (auto other = first + 1; other != last; ++other) whole.force += bond_at(*other).force;
    const int parts_before = opened_parts(whole);
    hold(bodies, first->first, first->second, whole, dt);
    have_bonds_opened_ |= opened_parts(whole) > parts_before;
    for (; first != last; ++first) {
      bond_at(*first).opening = whole.opening;
      if (!whole.holds()) bond_at(*first) = {};
    }
  }
  if (std::erase_if(bonds_, [&](const BondedCorner& at) { return !bond_at(at).holds(); }) > 0) tie_edges(bodies);
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
