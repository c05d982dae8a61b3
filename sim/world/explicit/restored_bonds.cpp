#include "sim/world/explicit/restored_bonds.h"

#include <algorithm>

#include "sim/world/state/world_state.h"

namespace griffith {

CracksByFace::CracksByFace(const explicit_dynamics::MicrostepContacts& contacts, int slots)
    : crack_of_face_(4 * static_cast<std::size_t>(slots), -1) {
  for (int i = 0; i < contacts.crack_count(); ++i) add(contacts, i);
}

void CracksByFace::add(const explicit_dynamics::MicrostepContacts& contacts, int crack) {
  const explicit_dynamics::CrackSides& sides = contacts.crack(crack);
  crack_of_face_[4 * sides.first_slot + face_of(sides.first_corners)] = crack;
  crack_of_face_[4 * sides.second_slot + face_of(sides.second_corners)] = crack;
}

void CracksByFace::bond(explicit_dynamics::MicrostepContacts& contacts, const OpenFace& face, int first_slot,
                        int corner, const Bond& bond) const {
  const int crack = crack_of_face_[4 * first_slot + face_of(face.first_corners)];
  if (crack < 0) return;
  const explicit_dynamics::CrackSides& sides = contacts.crack(crack);
  const std::array<int, 3>& corners = sides.first_slot == first_slot ? sides.first_corners : sides.second_corners;
  const auto place = std::ranges::find(corners, face.first_corners[corner]) - corners.begin();
  contacts.bond(crack, static_cast<int>(place), bond);
}

CracksByFace restore_bonds(const WorldState& world, std::span<const int> slot_of_tet,
                           explicit_dynamics::ExplicitBodies& bodies, explicit_dynamics::MicrostepContacts& contacts) {
  CracksByFace cracks(contacts, bodies.tet_slots());
  for (const CohesiveFace& known : world.cohesive_faces) {
    const int first = slot_of_tet[known.face.first], second = slot_of_tet[known.face.second];
    if (first < 0 || second < 0) continue;
    const Body& body = world.bodies[world.elements.bodies[known.face.first]];
    const double f = body.explicit_state ? body.explicit_state->similarity : 1;
    for (int i = 0; i < 3; ++i) {
      Bond acting = known.bonds[i];
      if (!acting.holds()) continue;
      acting.force *= f, acting.critical /= f;
      const Vec3 between = bodies.position(bodies.corner(second, known.face.second_corners[i])) -
                           bodies.position(bodies.corner(first, known.face.first_corners[i]));
      acting.opening = std::max(acting.opening / f, between.norm());
      if (acting.opening < acting.critical) cracks.bond(contacts, known.face, first, i, acting);
    }
  }
  contacts.tie_edges(bodies);
  return cracks;
}

}  // namespace griffith
