#include <algorithm>

#include "sim/fracture/cohesion.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/fracture/new_bonds.h"

namespace griffith {

/// Bonds the copies of a node that has just come apart, which was loaded `utilization` times its resistance.
void ExplicitRun::bond_copies(NodeId original, std::span<const NodeId> made, double utilization) {
  const Mat3& turn = turns_[explicit_bodies_.body_of_node(local(original))];
  const PartedNode parted{original, made, utilization, body_of(original).explicit_state->similarity, turn};
  const auto acceleration = [&](NodeId copy) { return explicit_bodies_.acceleration(local(copy)); };
  for (const auto& [face, corner, bond] : bonds_between(world_, parted, acceleration))
    cracks_by_face_.bond(*contacts_, face, slot_of_tet_[face.first], corner, bond);
}

/// Lets a world, that of the run or a copy of it, know of the bonds that hold.
void ExplicitRun::store_bonds(WorldState& world) const {
  std::vector<bool> is_followed(slot_of_tet_.size());
  for (std::size_t tet = 0; tet < is_followed.size(); ++tet) is_followed[tet] = slot_of_tet_[tet] >= 0;
  free_cohesive_faces(world, is_followed);
  for (int i = 0; i < contacts_->crack_count(); ++i) {
    const explicit_dynamics::CrackSides& crack = contacts_->crack(i);
    const TetId first = tets_[crack.first_slot], second = tets_[crack.second_slot];
    CohesiveFace face{{first, second, crack.first_corners, crack.second_corners}, crack.bonds};
    const double f = body_of(world.mesh->tets[first][0]).explicit_state->similarity;
    for (Bond& bond : face.bonds) bond.force /= f, bond.critical *= f, bond.opening *= f;
    add_cohesive_face(world, face);
  }
}

}  // namespace griffith
