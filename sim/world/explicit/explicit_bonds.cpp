#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sim/fracture/cohesion.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
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
    for (const auto& [face, corner, part] : pair.corners) bond(*face, corner, {stress * area * part / whole, critical});
  }
}

/// Returns the stress that a front at its critical load shows at a node, as it acts in the bodies [Pa].
double ExplicitRun::front_stress(NodeId node) const {
  const Body& body = body_of(node);
  const Material& material = world_.material_of(body);
  const double critical = material.fracture_toughness / std::sqrt(2 * std::numbers::pi * element_size_at(world_, node));
  return body.explicit_state->similarity * std::min(material.tensile_strength, critical);
}

void ExplicitRun::bond(const OpenFace& face, int corner, const Bond& bond) {
  const int first = crack_of_side_[4 * slot_of_tet_[face.first] + explicit_dynamics::face_of(face.first_corners)];
  if (first < 0) return;  // a slit that was in the mesh from the start holds nothing
  const explicit_dynamics::CrackSides& crack = contacts_->crack(first);
  const bool is_first = crack.first_slot == slot_of_tet_[face.first];
  const std::array<int, 3>& corners = is_first ? crack.first_corners : crack.second_corners;
  const auto place = std::ranges::find(corners, face.first_corners[corner]) - corners.begin();
  contacts_->bond(first, static_cast<int>(place), bond);
}

/// Notes which crack a face of the bodies is a side of.
void ExplicitRun::list_crack(int index) {
  const explicit_dynamics::CrackSides& crack = contacts_->crack(index);
  crack_of_side_[4 * crack.first_slot + explicit_dynamics::face_of(crack.first_corners)] = index;
  crack_of_side_[4 * crack.second_slot + explicit_dynamics::face_of(crack.second_corners)] = index;
}

/// Bonds faces as the world knows it. What has opened since the last microsteps has broken so far for nothing.
void ExplicitRun::restore_bonds() {
  crack_of_side_.assign(4 * tets_.size(), -1);
  for (int i = 0; i < contacts_->crack_count(); ++i) list_crack(i);
  for (const CohesiveFace& known : world_.cohesive_faces) {
    const int first = slot_of_tet_[known.face.first], second = slot_of_tet_[known.face.second];
    if (first < 0 || second < 0) continue;
    const double f = body_of(world_.mesh->tets[known.face.first][0]).explicit_state->similarity;
    for (int i = 0; i < 3; ++i) {
      Bond acting = known.bonds[i];
      if (!acting.holds()) continue;
      acting.force *= f, acting.critical /= f;
      const Vec3 between = explicit_bodies_.position(explicit_bodies_.corner(second, known.face.second_corners[i])) -
                           explicit_bodies_.position(explicit_bodies_.corner(first, known.face.first_corners[i]));
      acting.opening = std::max(acting.opening / f, between.norm());
      if (acting.opening < acting.critical) bond(known.face, i, acting);
    }
  }
  contacts_->tie_edges(explicit_bodies_);
}

/// Lets the world know of the bonds that hold.
void ExplicitRun::store_bonds() {
  std::erase_if(world_.cohesive_faces, [&](const CohesiveFace& face) { return slot_of_tet_[face.face.first] >= 0; });
  for (int i = 0; i < contacts_->crack_count(); ++i) {
    const explicit_dynamics::CrackSides& crack = contacts_->crack(i);
    if (std::ranges::none_of(crack.bonds, &Bond::holds)) continue;
    const TetId first = tets_[crack.first_slot], second = tets_[crack.second_slot];
    CohesiveFace face{{first, second, crack.first_corners, crack.second_corners}, crack.bonds};
    const double f = body_of(world_.mesh->tets[first][0]).explicit_state->similarity;
    for (Bond& bond : face.bonds) bond.force /= f, bond.critical *= f, bond.opening *= f;
    world_.cohesive_faces.push_back(face);
  }
}

/// Drops the bonds between pieces that the cracks since that event have separated entirely: pieces move on their own,
/// whether microsteps still follow them together or not.
void ExplicitRun::drop_parted_bonds(std::size_t first_event) {
  std::set<BodyId> opened;
  for (std::size_t i = first_event; i < world_.crack_events.size(); ++i) opened.insert(world_.crack_events[i].body);
  std::vector<int> piece_of_slot(tets_.size(), -1);
  int pieces = 0;
  for (const BodyId body : opened)
    for (const std::vector<TetId>& piece : connected_components(world_.mesh, world_.bodies[body].tets)) {
      for (const TetId tet : piece) piece_of_slot[slot_of_tet_[tet]] = pieces;
      ++pieces;
    }
  if (pieces > static_cast<int>(opened.size()))
    contacts_->drop_bonds([&](const explicit_dynamics::CrackSides& crack) {
      return piece_of_slot[crack.first_slot] != piece_of_slot[crack.second_slot];
    });
}

}  // namespace griffith
