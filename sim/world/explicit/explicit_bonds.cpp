#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/fracture/cohesion.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/explicit/explicit_run.h"
#include "sim/world/fracture/separation_phase.h"

namespace griffith {
namespace {

/// Bonds continue the stress at which a node opened, but for this fraction, lest rounding errors keep them in balance.
constexpr double kContinued = 0.999;
/// Nodes that come apart beside an opening node may carry next to nothing. Their bonds begin at no less than this
/// fraction of the stress at a front at its critical load: they would reach farther than an element otherwise.
constexpr double kLeastStress = 0.5;

/// Face corners of two copies of a node that coincide, and the area between them.
struct PartedCopies {
  NodeId first, second;
  Vec3 area = Vec3::Zero();  ///< a third of all faces, out of the first [m²]
  struct FaceCorner {
    const OpenFace* face;
    int corner;
    double area;  ///< [m²]
  };
  std::vector<FaceCorner> corners;
};

/// Returns the pairs of copies between which faces are open.
std::vector<PartedCopies> copies_between(const TetMesh& mesh, std::span<const NodeId> copies,
                                         std::span<const OpenFace> faces) {
  std::vector<PartedCopies> pairs;
  const auto is_copy = [&](NodeId node) { return std::ranges::find(copies, node) != copies.end(); };
  for (const OpenFace& face : faces) {
    const Vec3 third = third_of_face(mesh, face.first, face.first_corners);
    for (int i = 0; i < 3; ++i) {
      NodeId first = mesh.tets[face.first][face.first_corners[i]],
             second = mesh.tets[face.second][face.second_corners[i]];
      if (!is_copy(first) || !is_copy(second) || first == second) continue;
      const bool swaps = second < first;
      if (swaps) std::swap(first, second);
      auto pair = std::ranges::find_if(
          pairs, [&](const PartedCopies& known) { return known.first == first && known.second == second; });
      if (pair == pairs.end()) pair = pairs.insert(pairs.end(), {first, second, Vec3::Zero(), {}});
      pair->area += swaps ? Vec3(-third) : third;
      pair->corners.push_back({&face, i, third.norm()});
    }
  }
  return pairs;
}

}  // namespace

/// Bonds the copies of a node that has just come apart, across the faces between them: at the stress that they carry,
/// or that they could carry if it exceeds that `utilization` times.
void ExplicitRun::bond_copies(NodeId original, std::span<const NodeId> made, double utilization) {
  if (!fracture_law(world_.material_of(body_of(original))).is_stress()) return;
  std::vector<NodeId> copies = {original};
  copies.insert(copies.end(), made.begin(), made.end());
  const std::vector<OpenFace> faces = open_faces_at(world_.mesh, copies);
  double mass = 0;
  for (const NodeId copy : copies) mass += world_.nodes.masses[copy];
  for (const PartedCopies& pair : copies_between(world_.mesh, copies, faces)) {
    const double area = pair.area.norm();
    if (area == 0) continue;
    const Vec3 apart =
        explicit_bodies_.acceleration(local(pair.second)) - explicit_bodies_.acceleration(local(pair.first));
    Vec3 force = world_.nodes.masses[pair.first] * world_.nodes.masses[pair.second] / mass * apart;
    const Vec3 normal = turns_[explicit_bodies_.body_of_node(local(pair.first))] * pair.area / area;
    force -= std::min(0.0, force.dot(normal)) * normal;
    const double stress =
        std::max(kContinued * force.norm() / (utilization * area), kLeastStress * front_stress(original));
    const double critical = 2 * fracture_energy_at(world_, original, normal) / stress;
    double whole = 0;
    for (const auto& corner : pair.corners) whole += corner.area;
    for (const auto& [face, corner, part] : pair.corners)
      cracks_by_face_.bond(*contacts_, *face, slot_of_tet_[face->first], corner,
                           {stress * area * part / whole, critical});
  }
}

/// Returns the stress that a front at its critical load shows at a node, as it acts in the bodies [Pa].
double ExplicitRun::front_stress(NodeId node) const {
  const Body& body = body_of(node);
  const Material& material = world_.material_of(body);
  const double critical = material.fracture_toughness / std::sqrt(2 * std::numbers::pi * element_size_at(world_, node));
  return body.explicit_state->similarity * std::min(material.tensile_strength, critical);
}

/// Lets a world, that of the run or a copy of it, know of the bonds that hold.
void ExplicitRun::store_bonds(WorldState& world) const {
  std::vector<bool> is_followed(slot_of_tet_.size());
  for (std::size_t tet = 0; tet < is_followed.size(); ++tet) is_followed[tet] = slot_of_tet_[tet] >= 0;
  free_cohesive_faces(world, is_followed);
  for (int i = 0; i < contacts_->crack_count(); ++i) {
    const explicit_dynamics::CrackSides& crack = contacts_->crack(i);
    if (std::ranges::none_of(crack.bonds, &Bond::holds)) continue;
    const TetId first = tets_[crack.first_slot], second = tets_[crack.second_slot];
    CohesiveFace face{{first, second, crack.first_corners, crack.second_corners}, crack.bonds};
    const double f = body_of(world.mesh->tets[first][0]).explicit_state->similarity;
    for (Bond& bond : face.bonds) bond.force /= f, bond.critical *= f, bond.opening *= f;
    add_cohesive_face(world, face);
  }
}

}  // namespace griffith
