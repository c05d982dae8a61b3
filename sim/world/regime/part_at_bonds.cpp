#include "sim/world/regime/part_at_bonds.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Marks the tets of the parts of a body that have to deform: those with supports, or all if there are none.
void mark_deformable_parts(const WorldState& world, const Body& body, std::vector<bool>& marked) {
  for (const std::vector<TetId>& part : connected_components(world.mesh, body.tets)) {
    const auto is_held = [&](NodeId node) { return world.nodes.has_support[node] != 0; };
    const bool deforms = !body.supported() || std::ranges::any_of(nodes_of(world.mesh, part), is_held);
    for (const TetId tet : part) marked[tet] = deforms;
  }
}

bool is_parted(const Body& body) { return body.bonded && body.is_deformable(); }

/// Bonds between two parts of a body.
struct BondsBetween {
  std::vector<std::ptrdiff_t> faces;  ///< indices of the opened faces
  double energy = 0;                  ///< energy that their bonds can still take [J]
  double square = 0;                  ///< sum over the faces of the square of their speed of opening [m²/s²]
};

Vec3 center_of(const WorldState& world, TetId tet, const std::array<int, 3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (const int corner : corners) sum += world.nodes.positions[world.mesh->tets[tet][corner]];
  return sum / 3;
}

/// Returns the speed at which the sides of a face go on opening [m/s], >= 0; `first`, `second`: motions of their parts.
double opening_speed(const WorldState& world, const OpenFace& face, const RigidMotion& first,
                     const RigidMotion& second) {
  const Vec3 a = center_of(world, face.first, face.first_corners),
             b = center_of(world, face.second, face.second_corners);
  const double gap = (b - a).norm();
  return gap > 0 ? std::max(0.0, (second.velocity_at(b) - first.velocity_at(a)).dot(b - a) / gap) : 0;
}

/// Finds the opened faces of a body between parts that its bonds cannot hold.
void find_torn_faces(const WorldState& world, const Body& body, std::vector<std::ptrdiff_t>& torn) {
  const ConnectedParts parts(world, body);
  std::vector<RigidMotion> motions;
  for (const std::vector<TetId>& part : parts.tets()) motions.push_back(motion_of(world, nodes_of(world.mesh, part)));
  std::map<std::pair<int, int>, BondsBetween> bonds;
  for (std::size_t i = 0; i < world.cohesive_faces.size(); ++i) {
    const auto& [face, of_corners] = world.cohesive_faces[i];
    if (world.elements.bodies[face.first] != body.id || world.elements.bodies[face.second] != body.id) continue;
    const int first = parts.of(face.first), second = parts.of(face.second);
    if (first == second) continue;
    BondsBetween& between = bonds[std::minmax(first, second)];
    between.faces.push_back(static_cast<std::ptrdiff_t>(i));
    for (const Bond& bond : of_corners)
      if (bond.holds()) between.energy += bond.energy_left();
    const double speed = opening_speed(world, face, motions[first], motions[second]);
    between.square += speed * speed;
  }
  for (const auto& [pair, between] : bonds) {
    const double first = motions[pair.first].mass, second = motions[pair.second].mass;
    const double available = first * second / (first + second) * between.square / (2.0 * between.faces.size());
    if (available > between.energy) torn.insert(torn.end(), between.faces.begin(), between.faces.end());
  }
}

}  // namespace

void part_at_torn_bonds(WorldState& world) {
  Opened opened;
  opened.first_event = world.crack_events.size();
  std::vector<std::ptrdiff_t> torn;
  for (const Body& body : world.bodies) {
    if (!is_parted(body) || body.supported()) continue;
    const std::size_t before = torn.size();
    find_torn_faces(world, body, torn);
    if (torn.size() > before) opened.bodies.insert(body.id);
  }
  if (torn.empty()) return;
  std::ranges::sort(torn, std::ranges::greater());
  for (const std::ptrdiff_t face : torn) remove_cohesive_face(world, face);
  part_opened(world, opened);
}

void part_at_bonds(WorldState& world) {
  if (std::ranges::none_of(world.bodies, is_parted)) return;
  Opened opened;
  opened.first_event = world.crack_events.size();
  std::vector<bool> is_freed(world.mesh->tets.size());
  for (const Body& body : world.bodies) {
    if (!is_parted(body)) continue;
    mark_deformable_parts(world, body, is_freed);
    opened.bodies.insert(body.id);
  }
  free_cohesive_faces(world, is_freed);
  part_opened(world, opened);
  for (Body& body : world.bodies)
    if (is_parted(body)) stop_vibration(world, body);
}

}  // namespace griffith
