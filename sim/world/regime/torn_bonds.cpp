#include "sim/world/regime/torn_bonds.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Bonds between two clusters.
struct BondsBetween {
  std::vector<std::ptrdiff_t> faces;  ///< indices of the opened faces
  double energy = 0;                  ///< energy that the bonds can still take [J]

  void add(const BondsBetween& other) {
    faces.insert(faces.end(), other.faces.begin(), other.faces.end());
    energy += other.energy;
  }
};

/// Parts of a body, between opened faces, that move as one or that bonds can bring to do so.
struct Cluster {
  std::vector<TetId> tets;  ///< none once it has joined another one
  RigidMotion motion;
  std::map<int, BondsBetween> bonds;  ///< by the index of the other cluster
};

/// Returns the indices of the opened faces within each body.
std::vector<std::vector<std::ptrdiff_t>> faces_by_body(const WorldState& world) {
  std::vector<std::vector<std::ptrdiff_t>> faces(world.bodies.size());
  for (std::size_t i = 0; i < world.cohesive_faces.size(); ++i) {
    const OpenFace& face = world.cohesive_faces[i].face;
    const BodyId body = world.elements.bodies[face.first];
    if (body == world.elements.bodies[face.second]) faces[body.index()].push_back(static_cast<std::ptrdiff_t>(i));
  }
  return faces;
}

/// `faces`: indices of the opened faces within the body.
std::vector<Cluster> parts_of(const WorldState& world, const Body& body, std::span<const std::ptrdiff_t> faces) {
  const ConnectedParts connected(world, body);
  std::vector<Cluster> parts;
  for (const std::vector<TetId>& tets : connected.tets())
    parts.push_back({tets, motion_of(world, nodes_of(world.mesh, tets)), {}});
  for (const std::ptrdiff_t index : faces) {
    const auto& [face, of_corners] = world.cohesive_faces[index];
    const int first = connected.of(face.first), second = connected.of(face.second);
    if (first == second) continue;
    BondsBetween between{{index}, 0};
    for (const Bond& bond : of_corners)
      if (bond.holds()) between.energy += bond.energy_left();
    parts[first].bonds[second].add(between);
    parts[second].bonds[first].add(between);
  }
  return parts;
}

/// Returns the energy of the motion of two clusters against each other [J], which they would lose as one rigid body.
double energy_apart(const RigidMotion& a, const RigidMotion& b) {
  return kinetic_energy(a) + kinetic_energy(b) - kinetic_energy(joined_motion(a, b));
}

/// Two bonded clusters.
struct Pair {
  double load = 0;  ///< energy of their motion against each other, over that which their bonds can take
  int first = 0, second = 0;
  auto operator<=>(const Pair&) const = default;
};

/// Returns the pairs whose bonds can stop their motion against each other, the least loaded ones first.
std::vector<Pair> holding_pairs(const std::vector<Cluster>& clusters) {
  std::vector<Pair> pairs;
  for (int first = 0; first < std::ssize(clusters); ++first)
    for (const auto& [second, bonds] : clusters[first].bonds) {
      if (second < first || bonds.energy == 0) continue;
      const double energy = energy_apart(clusters[first].motion, clusters[second].motion);
      if (energy <= bonds.energy) pairs.push_back({energy / bonds.energy, first, second});
    }
  std::ranges::sort(pairs);
  return pairs;
}

/// Joins the second cluster of a pair with the first.
void join(std::vector<Cluster>& clusters, const Pair& pair) {
  Cluster &kept = clusters[pair.first], joined = std::exchange(clusters[pair.second], {});
  kept.motion = joined_motion(kept.motion, joined.motion);
  kept.tets.insert(kept.tets.end(), joined.tets.begin(), joined.tets.end());
  kept.bonds.erase(pair.second);
  for (const auto& [other, bonds] : joined.bonds) {
    clusters[other].bonds.erase(pair.second);
    if (other == pair.first) continue;
    kept.bonds[other].add(bonds);
    clusters[other].bonds[pair.first].add(bonds);
  }
}

/// Joins clusters as long as bonds can stop their motion against each other.
void join_what_holds(std::vector<Cluster>& clusters) {
  for (std::vector<Pair> pairs = holding_pairs(clusters); !pairs.empty(); pairs = holding_pairs(clusters)) {
    std::vector<bool> has_changed(clusters.size());
    for (const Pair& pair : pairs) {
      if (has_changed[pair.first] || has_changed[pair.second]) continue;
      has_changed[pair.first] = has_changed[pair.second] = true;
      join(clusters, pair);
    }
  }
}

/// Adds a fraction of what a cluster lacks of another rigid motion to its velocities.
void approach(WorldState& world, Cluster& cluster, const RigidMotion& aim, double fraction) {
  RigidMotion& motion = cluster.motion;
  const Vec3 change = fraction * (aim.velocity_at(motion.center) - motion.velocity),
             spin = fraction * (aim.angular_velocity - motion.angular_velocity);
  for (const NodeId node : nodes_of(world.mesh, cluster.tets))
    world.nodes.velocities[node] += change + spin.cross(world.nodes.positions[node] - motion.center);
  for (const EdgeId edge : edges_of(world.tet_edges, cluster.tets))
    world.edges.velocities[edge] += spin.cross(world.edges.offsets[edge]);
  motion.velocity += change;
  motion.angular_velocity += spin;
}

/// Takes the energy of the bonds between two clusters from their motion against each other. False if they hold.
bool tear(WorldState& world, const BondsBetween& bonds, Cluster& first, Cluster& second) {
  const double energy = energy_apart(first.motion, second.motion);
  if (energy <= bonds.energy) return bonds.energy == 0;
  const RigidMotion joined = joined_motion(first.motion, second.motion);
  const double fraction = 1 - std::sqrt(1 - bonds.energy / energy);
  approach(world, first, joined, fraction);
  approach(world, second, joined, fraction);
  world.energy.fracture += bonds.energy;
  return true;
}

/// Tears bonds of a body at its opened `faces`. Adds the indices of those that are free then.
void tear_bonds(WorldState& world, const Body& body, std::span<const std::ptrdiff_t> faces,
                std::vector<std::ptrdiff_t>& torn) {
  std::vector<Cluster> clusters = parts_of(world, body, faces);
  join_what_holds(clusters);
  for (int first = 0; first < std::ssize(clusters); ++first)
    for (const auto& [second, bonds] : clusters[first].bonds)
      if (first < second && tear(world, bonds, clusters[first], clusters[second]))
        torn.insert(torn.end(), bonds.faces.begin(), bonds.faces.end());
}

}  // namespace

std::vector<BodyId> part_at_torn_bonds(WorldState& world, std::span<const BodyId> bodies) {
  Opened opened;
  opened.first_event = world.crack_events.size();
  std::vector<std::ptrdiff_t> torn;
  const std::vector<std::vector<std::ptrdiff_t>> faces = faces_by_body(world);
  for (const BodyId id : bodies) {
    const Body& body = world.bodies[id];
    if (!body.bonded || !body.is_deformable() || body.supported()) continue;
    const std::size_t before = torn.size();
    tear_bonds(world, body, faces[id.index()], torn);
    if (torn.size() > before) opened.bodies.insert(id);
  }
  std::vector<BodyId> pieces(bodies.begin(), bodies.end());
  if (torn.empty()) return pieces;
  std::ranges::sort(torn, std::ranges::greater());
  for (const std::ptrdiff_t face : torn) remove_cohesive_face(world, face);
  const std::size_t first_new = world.bodies.size();
  part_opened(world, opened);
  for (std::size_t i = first_new; i < world.bodies.size(); ++i) pieces.push_back(world.bodies[i].id);
  return pieces;
}

}  // namespace griffith
