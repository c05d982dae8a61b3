#include "sim/world/fracture/new_bonds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/fracture/fracture_law.h"
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

}  // namespace griffith
