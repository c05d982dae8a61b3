#include "sim/world/fracture/new_bonds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/elasticity/placement.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/fracture/fracture_law.h"
#include "sim/world/bodies/bonded_pieces.h"
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

/// Returns the stress that a front at its critical load shows at a node, as it acts in its body [Pa].
double front_stress(const WorldState& world, const PartedNode& parted) {
  const Body& body = world.bodies[world.elements.bodies[world.mesh->stars[parted.original].front()]];
  const Material& material = world.material_of(body);
  const double size = element_size_at(world, parted.original);
  const double critical = material.fracture_toughness / std::sqrt(2 * std::numbers::pi * size);
  return parted.similarity * std::min(material.tensile_strength, critical);
}

}  // namespace

std::vector<NewBond> bonds_between(const WorldState& world, const PartedNode& parted,
                                   const std::function<Vec3(NodeId)>& acceleration) {
  std::vector<NewBond> bonds;
  const Body& body = world.bodies[world.elements.bodies[world.mesh->stars[parted.original].front()]];
  if (!fracture_law(world.material_of(body)).is_stress()) return bonds;
  std::vector<NodeId> copies = {parted.original};
  copies.insert(copies.end(), parted.copies.begin(), parted.copies.end());
  const std::vector<OpenFace> faces = open_faces_at(world.mesh, copies);
  double mass = 0;
  for (const NodeId copy : copies) mass += world.nodes.masses[copy];
  for (const PartedCopies& pair : copies_between(world.mesh, copies, faces)) {
    const double area = pair.area.norm();
    if (area == 0) continue;
    const Vec3 apart = acceleration(pair.second) - acceleration(pair.first);
    Vec3 force = world.nodes.masses[pair.first] * world.nodes.masses[pair.second] / mass * apart;
    const Vec3 normal = parted.turn * pair.area / area;
    force -= std::min(0.0, force.dot(normal)) * normal;
    const double stress =
        std::max(kContinued * force.norm() / (parted.utilization * area), kLeastStress * front_stress(world, parted));
    const double critical = 2 * fracture_energy_at(world, parted.original, normal) / stress;
    double whole = 0;
    for (const auto& corner : pair.corners) whole += corner.area;
    for (const auto& [face, corner, part] : pair.corners)
      bonds.push_back({*face, corner, {stress * area * part / whole, critical}});
  }
  return bonds;
}

namespace {

/// Returns the acceleration of a node by the forces of its elements alone [m/s²].
Vec3 acceleration_by_elements(const WorldState& world, NodeId node) {
  Vec3 force = Vec3::Zero();
  for (const TetId tet : world.mesh->stars[node]) {
    const RestElement& rest = world.elements.rest_elements[tet];
    const int corner = local_corner(world.mesh, tet, node);
    force += world.tet_edges->is_quadratic(tet)
                 ? Vec3(quadratic_forces(rest, world.elements.quadratic_states[tet]).corners.col(corner))
                 : corner_force(rest, world.elements.states[tet], corner);
  }
  return world.nodes.constraints[node].allowed * force / world.nodes.masses[node];
}

/// Adds a bond to those of its face. A slit that was in the mesh from the start is no crack and holds nothing.
void add_bond(WorldState& world, const NewBond& made) {
  if (world.elements.first_surface[made.face.first] >> griffith::face_of(made.face.first_corners) & 1) return;
  CohesiveFace added{made.face, {}};
  for (int corner = 0; corner < 3; ++corner)
    if (is_at_front(world.mesh, made.face, corner)) added.bonds[corner] = Bond::closed();
  const auto known = std::ranges::find_if(world.cohesive_faces, [&](const CohesiveFace& other) {
    return (other.face.first == made.face.first && other.face.second == made.face.second) ||
           (other.face.first == made.face.second && other.face.second == made.face.first);
  });
  int corner = made.corner;
  if (known != world.cohesive_faces.end()) {
    const bool is_same_way = known->face.first == made.face.first;
    const std::array<int, 3>& corners = is_same_way ? known->face.first_corners : known->face.second_corners;
    corner = static_cast<int>(std::ranges::find(corners, made.face.first_corners[made.corner]) - corners.begin());
    added = *known;
    remove_cohesive_face(world, known - world.cohesive_faces.begin());
  }
  added.bonds[corner] = made.bond;
  add_cohesive_face(world, added);
}

}  // namespace

void bond_copies(WorldState& world, NodeId original, std::span<const NodeId> copies, double utilization) {
  const Mat3 turn = best_rotation(world.elements.states[world.mesh->stars[original].front()].frame);
  const std::vector<NewBond> bonds = bonds_between(world, {original, copies, utilization, 1, turn},
                                                   [&](NodeId copy) { return acceleration_by_elements(world, copy); });
  for (const NewBond& made : bonds) add_bond(world, made);
}

}  // namespace griffith
