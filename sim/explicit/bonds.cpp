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

/// Lists the bonds that hold, those between the same nodes together.
void MicrostepContacts::list_bonds(const ExplicitBodies& bodies) {
  struct Corner : CornerOfCrack {
    std::pair<int, int> nodes;
  };
  std::vector<Corner> corners;
  for (int index = 0; index < crack_count(); ++index) {
    const CrackSides& crack = cracks_[index].sides;
    for (int i = 0; i < 3; ++i)
      if (crack.bonds[i].holds())
        corners.push_back({{index, i},
                           std::minmax({bodies.corner(crack.first_slot, crack.first_corners[i]),
                                        bodies.corner(crack.second_slot, crack.second_corners[i])})});
  }
  std::ranges::stable_sort(corners, {}, &Corner::nodes);
  bonds_.clear(), bonded_corners_.clear();
  for (const Corner& corner : corners) {
    const auto [first, second] = corner.nodes;
    if (bonds_.empty() || bonds_.back().first != first || bonds_.back().second != second)
      bonds_.push_back({first, second, static_cast<int>(bonded_corners_.size()), 0, bond_at(corner)});
    else
      bonds_.back().whole.force += bond_at(corner).force;
    bonded_corners_.push_back(corner);
    ++bonds_.back().count;
  }
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
  bool any_broken = false;
  for (BondedNodes& bond : bonds_) {
    const Vec3 between = bodies.position(bond.second) - bodies.position(bond.first);
    const double opening = between.norm();
    if (opening <= bond.whole.opening) continue;
    const int parts_before = opened_parts(bond.whole);
    hold(bodies, bond, between / opening, opening, dt);
    have_bonds_opened_ |= opened_parts(bond.whole) > parts_before;
    any_broken |= !bond.whole.holds();
    for (const CornerOfCrack& corner : std::span(bonded_corners_).subspan(bond.first_corner, bond.count)) {
      if (bond.whole.holds())
        bond_at(corner).opening = bond.whole.opening;
      else
        bond_at(corner) = {};
    }
  }
  if (!any_broken) return;
  std::erase_if(bonds_, [](const BondedNodes& bond) { return !bond.whole.holds(); });
  tie_edges(bodies);
}

/// The impulse belongs to the forces before the last motion, part of which it takes back. The bond takes the energy of
/// its law; what the microstep's impulse takes more or less is a loss like that of contacts.
void MicrostepContacts::hold(ExplicitBodies& bodies, BondedNodes& bonded, const Vec3& direction, double opening,
                             double dt) {
  const auto [first, second] = std::pair(bonded.first, bonded.second);
  Bond& bond = bonded.whole;
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
