#include "sim/world/bodies/bodies.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/elasticity/element.h"
#include "sim/fracture/crack_front.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/bodies/collision_shape.h"
#include "sim/world/bodies/impact_speeds.h"
#include "sim/world/bodies/supported_motion.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/motion/turning.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the values of a body's nodes or edges as columns.
template <class Identifier>
NodeVectors gather(const std::vector<Vec3>& values, const std::vector<Identifier>& ids) {
  NodeVectors gathered(3, ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) gathered.col(i) = values[ids[i]];
  return gathered;
}

Eigen::VectorXd gather(const std::vector<double>& values, const std::vector<NodeId>& nodes) {
  Eigen::VectorXd gathered(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) gathered[i] = values[nodes[i]];
  return gathered;
}

/// Returns the proxy of a body in its present state.
ContactWorld::Proxy proxy_of(const WorldState& world, const Body& body) {
  const Material& material = world.material_of(body);
  return {body.collision_parts,
          {body.motion.mass, body.motion.inertia},
          body.supported() ? Mobility::kinematic : Mobility::free,
          proxy_state(world, body),
          {material.friction, material.restitution}};
}

void reshape_proxy(WorldState& world, const Body& body) {
  const auto [parts, mass, mobility, state, surface] = proxy_of(world, body);
  world.contact_world.reshape(body.proxy, parts, mass, mobility, state);
  world.contact_world.set_impact_speed(body.proxy, examined_impact_speed(world, body));
}

/// Returns the longest edge of the box around the body at rest [m].
double extent_of(const WorldState& world, const Body& body) {
  Eigen::AlignedBox3d box;
  for (NodeId node : body.nodes) box.extend(world.mesh->rest_positions[node]);
  return box.sizes().maxCoeff();
}

/// True if no node is farther from where the proxy has it than `tolerance` [m].
bool is_shaped_like_proxy(const WorldState& world, const Body& body, double tolerance) {
  const NodeVectors placed = (body.orientation.toRotationMatrix() * body.reference_arms).colwise() + body.motion.center;
  const NodeVectors positions = gather(world.nodes.positions, body.nodes);
  return (positions - placed).colwise().norm().maxCoeff() <= tolerance;
}

/// Returns the fraction of the material's resistance that scatter and direction leave at the body's weakest node,
/// across its weakest plane [-].
double weakest_fraction_of(const WorldState& world, const Body& body) {
  double minimum = std::numeric_limits<double>::infinity();
  for (NodeId node : body.nodes) minimum = std::min(minimum, world.nodes.strength_factors[node]);
  const std::optional<Weakness>& weakness = world.model->weaknesses[body.scene_body];
  return weakness ? weakness->strength_ratio * minimum : minimum;
}

/// Returns the component that continues as the body itself: a supported one before a free one, then the largest.
std::size_t surviving_piece(const WorldState& world, const std::vector<std::vector<TetId>>& components) {
  const auto rank = [&](const std::vector<TetId>& tets) {
    const bool held = std::any_of(tets.begin(), tets.end(), [&](TetId tet) {
      const auto& corners = world.mesh->tets[tet];
      return std::any_of(corners.begin(), corners.end(),
                         [&](NodeId node) { return world.nodes.has_support[node] != 0; });
    });
    return std::pair(held, tets.size());
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < components.size(); ++i)
    if (rank(components[i]) > rank(components[best])) best = i;
  return best;
}

constexpr double kVisibleStrain = 1e-3;
constexpr std::size_t kDebris = 20;  // tets: the shape of fewer is not worth its cost

/// Returns the node speed below which waves stay far below a stress [m/s]: half of σ/(ρc).
double speed_of_waves(const Material& material, double stress) {
  constexpr double kFraction = 0.5;
  return kFraction * stress / (material.density * bar_wave_speed(material));
}

}  // namespace

double damage_speed(const WorldState& world, const Body& body) {
  if (body.tets.size() == 1) return std::numeric_limits<double>::infinity();
  return speed_of_waves(world.material_of(body), min_breaking_stress(world, body, false));
}

double visible_speed(const WorldState& world, const Body& body) {
  constexpr double kVisible = 3e-4;  // of its extent: with a load on it, it swings slower and farther
  const Material& material = world.material_of(body);
  const double of_waves = speed_of_waves(material, visible_stress(world, body));
  if (!is_thin(body) || body.tets.size() <= kDebris) return of_waves;
  const double thickness = 2 * body.depth, c = bar_wave_speed(material);
  const double slowest =
      std::numbers::pi * std::numbers::pi / std::sqrt(12.0) * c * thickness / (body.extent * body.extent);
  return std::min(of_waves, kVisible * body.extent * slowest);
}

bool all_slower(const WorldState& world, const Body& body, const RigidMotion& whole, double speed) {
  return std::ranges::all_of(body.nodes, [&](NodeId node) {
    return (world.nodes.velocities[node] - whole.velocity_at(world.nodes.positions[node])).norm() < speed;
  });
}

double min_breaking_stress(const WorldState& world, const Body& body, bool at_crack_front) {
  const Material& material = world.material_of(body);
  const double minimum = body.weakest_fraction * screening_resistance(material, at_crack_front, body.element_size);
  return fracture_law(material).is_stress() ? minimum : minimum / (body.element_size * body.element_size);
}

double visible_stress(const WorldState& world, const Body& body) {
  if (body.tets.size() <= kDebris) return std::numeric_limits<double>::infinity();
  return kVisibleStrain * world.material_of(body).young_modulus;
}

double bending_tolerance(const Body& body) {
  constexpr double kBent = 0.25;  // of its depth
  return kBent * body.depth;
}

bool is_thin(const Body& body) {
  constexpr double kThin = 0.1;  // of its extent
  return 2 * body.depth <= kThin * body.extent;
}

double bending_stress(const WorldState& world, const Body& body, double force) {
  const double volume = body.motion.mass / world.material_of(body).density, thickness = 2 * body.depth;
  return 1.5 * force * body.extent * body.extent / (volume * thickness);
}

double visible_bending_stress(const WorldState& world, const Body& body) {
  constexpr double kVisible = 5e-3;  // of the extent of what it is a piece of
  if (body.tets.size() <= kDebris) return std::numeric_limits<double>::infinity();
  const double deflection = kVisible * world.model->extents[body.scene_body], thickness = 2 * body.depth;
  return 6 * world.material_of(body).young_modulus * thickness * deflection / (body.extent * body.extent);
}

bool deforms_visibly(const WorldState& world, const Body& body) {
  return min_breaking_stress(world, body, false) > visible_stress(world, body);
}

bool is_strained_by(const WorldState& world, const Body& body, double strain) {
  const double energy_density = 0.5 * world.material_of(body).young_modulus * strain * strain;
  return std::ranges::any_of(body.tets,
                             [&](TetId tet) { return world.elements.states[tet].energy_density > energy_density; });
}

bool is_visibly_strained(const WorldState& world, const Body& body) {
  return deforms_visibly(world, body) && is_strained_by(world, body, kVisibleStrain);
}

bool sags_visibly(const WorldState& world, const Body& body) {
  const double stress = world.material_of(body).density * world.model->scene.gravity.norm() * body.extent;
  return stress > visible_stress(world, body);
}

void clear_stress(const Body& body, ElementArrays& elements, NodeArrays& nodes) {
  std::vector<ElementState>& states = elements.states.edit();
  std::vector<Mat3>& stresses = elements.stresses.edit();
  for (TetId tet : body.tets) {
    states[tet] = {};
    stresses[tet].setZero();
    if (!body.edges.empty()) elements.quadratic_states.edit()[tet] = {};
  }
  for (NodeId node : body.nodes) nodes.separations[node] = {};
}

RigidMotion motion_of(const WorldState& world, const std::vector<NodeId>& nodes) {
  return rigid_motion(gather(world.nodes.positions, nodes), gather(world.nodes.velocities, nodes),
                      gather(world.nodes.masses, nodes));
}

RigidMotion motion_of(const WorldState& world, const Body& body) { return motion_of(world, body.nodes); }

Placement placement_of(const WorldState& world, std::span<const NodeId> nodes) {
  return best_placement(world.mesh->rest_positions, world.nodes.positions, world.nodes.masses, nodes);
}

void update_motion(const WorldState& world, Body& body) {
  body.motion = motion_of(world, body);
  Mat3 correlation = Mat3::Zero();
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const NodeId node = body.nodes[i];
    correlation += world.nodes.masses[node] * (world.nodes.positions[node] - body.motion.center) *
                   body.reference_arms.col(i).transpose();
  }
  body.orientation = Quat(best_rotation(correlation)).normalized();
}

namespace {

/// True if the body goes on beyond a face: a plane of symmetry, or a support that holds it.
bool is_continued(const WorldState& world, TetId tet, const std::array<int, 3>& corners, const Vec3& normal) {
  return std::ranges::all_of(corners, [&](int corner) {
    const NodeConstraint& constraint = world.nodes.constraints[world.mesh->tets[tet][corner]];
    return !constraint.is_free() && (constraint.allowed * normal).norm() < 1e-6;
  });
}

}  // namespace

double depth_of(const WorldState& world, const Body& body) {
  double volume = 0, area = 0;
  for (const TetId tet : body.tets) volume += world.elements.rest_elements[tet].volume;
  for (const auto& [tet, face] : body.surface) {
    const std::array<int, 3>& corners = kTetFaces[face];
    const Vec3 third = third_of_face(world.mesh, tet, corners);
    if (!is_continued(world, tet, corners, third.normalized())) area += 3 * third.norm();
  }
  return area > 0 ? volume / area : std::numeric_limits<double>::infinity();
}

double rebuild_shape(WorldState& world, Body& body) {
  body.nodes = nodes_of(world.mesh, body.tets);
  body.surface.clear();
  for (TetId tet : body.tets)
    for (int face = 0; face < 4; ++face)
      if (!world.mesh->neighbors[tet][face].valid()) body.surface.push_back({tet, face});
  body.edges = edges_of(world.tet_edges, body.tets);
  if (!body.edges.empty()) {
    body.system.emplace(world.mesh, world.tet_edges, body.tets, world.nodes.constraints, world.nodes.constraints,
                        world.nodes.rows, world.edges.rows);
  } else if (body.system) {
    body.system->patch(world.mesh, body.nodes, world.nodes.constraints, world.nodes.rows);
  } else {
    body.system.emplace(world.mesh, body.tets, world.nodes.constraints, world.nodes.rows);
  }
  body.guided = is_guided(world, body);
  body.motion = motion_of(world, body);
  body.reference_arms = gather(world.nodes.positions, body.nodes).colwise() - body.motion.center;
  body.reference_offsets = gather(world.edges.offsets, body.edges);
  body.orientation.setIdentity();
  body.element_size = mean_element_size(world.elements.rest_elements, body.tets);
  body.bonded = connected_components(world.mesh, body.tets).size() > 1;
  // While it cracks, what it was before it was hit counts: its pieces were not thinner then.
  if (!body.explicit_state) body.depth = depth_of(world, body);
  body.extent = extent_of(world, body);
  body.weakest_fraction = weakest_fraction_of(world, body);
  body.asleep = body.ballistic = false;
  // A single tet cannot break any further: it is debris from the start.
  body.rigid = body.tets.size() == 1 && !body.supported();
  body.quiet_steps = 0;
  body.rest.time = 0;
  body.highest_frequency = 0;
  if (!body.rigid) return 0;
  update_elements(world, body);
  const double before = mechanical_energy(world, body);
  clear_stress(body, world.elements, world.nodes);
  return before - energy_of(world, body);
}

void add_proxies(WorldState& world, std::span<Body> bodies) {
  std::vector<ContactWorld::Proxy> added;
  for (const Body& body : bodies) added.push_back(proxy_of(world, body));
  const std::vector<ProxyId> ids = world.contact_world.add_proxies(added);
  if (ids.empty()) return;
  world.body_of_proxy.resize(ids.back().index() + 1);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    bodies[i].proxy = ids[i];
    world.body_of_proxy[ids[i]] = bodies[i].id;
    world.contact_world.set_impact_speed(ids[i], examined_impact_speed(world, bodies[i]));
  }
}

void rebuild_body(WorldState& world, Body& body) {
  rebuild_shape(world, body);
  body.collision_parts = collision_parts(world, body);
  reshape_proxy(world, body);
}

RigidState proxy_state(const WorldState& world, const Body& body) {
  const Pose pose{body.motion.center, body.orientation};
  if (!body.supported() || body.guided || is_driven(world, body))
    return {pose, body.motion.velocity, body.motion.angular_velocity};
  const std::optional<Pivot> pivot = pivot_of(world, body);
  if (!pivot) return {pose};  // it vibrates at most
  const Vec3 spin = turning_of(world, body, *pivot).spin;
  return {pose, spin.cross(body.motion.center - pivot->place), spin};
}

double shape_tolerance(const Body& body) {
  constexpr double kSameShape = 1e-4;  // of its extent: contacts of rigid bodies overlap by as much
  return kSameShape * body.extent;
}

void fit_proxy(WorldState& world, Body& body) {
  if (is_shaped_like_proxy(world, body, shape_tolerance(body))) return;
  body.reference_arms = gather(world.nodes.positions, body.nodes).colwise() - body.motion.center;
  body.reference_offsets = gather(world.edges.offsets, body.edges);
  body.orientation.setIdentity();
  body.collision_parts = collision_parts(world, body);
  reshape_proxy(world, body);
}

void follow_deformation(WorldState& world, Body& body) {
  constexpr double kDeformed = 5e-3;  // of its extent: contacts would be sought where the surface was
  if (is_shaped_like_proxy(world, body, std::min(kDeformed * body.extent, bending_tolerance(body)))) return;
  const Mat3 back = body.orientation.conjugate().toRotationMatrix();
  body.reference_arms = back * (gather(world.nodes.positions, body.nodes).colwise() - body.motion.center);
  body.reference_offsets = back * gather(world.edges.offsets, body.edges);
  body.collision_parts = collision_parts(world, body);
  for (ConvexPart& part : body.collision_parts)
    for (Vec3& corner : part) corner = back * corner;
  const auto [parts, mass, mobility, state, surface] = proxy_of(world, body);
  world.contact_world.deform(body.proxy, parts, mass, state);
}

void assign_pieces(WorldState& world, BodyId id, std::vector<std::vector<TetId>> pieces) {
  const std::size_t kept = surviving_piece(world, pieces);
  world.bodies[id].tets = std::move(pieces[kept]);
  for (TetId tet : world.bodies[id].tets) world.elements.bodies[tet] = id;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == kept) continue;
    Body piece;
    piece.id = BodyId(static_cast<std::int64_t>(world.bodies.size()));
    piece.parent = id;
    piece.scene_body = world.bodies[id].scene_body;
    piece.scaled = world.bodies[id].scaled;
    piece.broke_scaled = world.bodies[id].broke_scaled;
    piece.explicit_state = world.bodies[id].explicit_state;
    piece.explicit_ended = world.bodies[id].explicit_ended;
    piece.depth = world.bodies[id].depth;
    piece.tets = std::move(pieces[i]);
    for (TetId tet : piece.tets) world.elements.bodies[tet] = piece.id;
    world.bodies.push_back(std::move(piece));
  }
}

std::vector<BodyId> part_bodies(WorldState& world, std::span<const BodyId> opened) {
  std::vector<BodyId> pieces(opened.begin(), opened.end());
  const std::size_t first_new = world.bodies.size();
  const BondedPieces bonded(world);
  for (BodyId id : opened) assign_pieces(world, id, bonded.of(world.bodies[id]));
  for (std::size_t i = first_new; i < world.bodies.size(); ++i) pieces.push_back(world.bodies[i].id);
  return pieces;
}

void rebuild_pieces(WorldState& world, std::span<const BodyId> pieces) {
  world.elements.own_states();
  std::vector<double> lost(pieces.size(), 0.0);
  parallel_for(static_cast<int>(pieces.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Body& body = world.bodies[pieces[i]];
      lost[i] = rebuild_shape(world, body);
      body.collision_parts = collision_parts(world, body);
    }
  });
  for (const double energy : lost) world.energy.regime_change += energy;
  std::size_t first_new = world.bodies.size();
  for (const BodyId id : pieces) {
    if (world.bodies[id].proxy.valid()) reshape_proxy(world, world.bodies[id]);
    if (!world.bodies[id].proxy.valid()) first_new = std::min(first_new, static_cast<std::size_t>(id.index()));
  }
  add_proxies(world, std::span(world.bodies).subspan(first_new));
}

void add_spin_to_edges(const Body& body, const Vec3& spin, EdgeArrays& edges) {
  for (const EdgeId edge : body.edges) edges.velocities[edge] += spin.cross(edges.offsets[edge]);
}

void restore_spin(WorldState& world, const Body& body, const RigidMotion& before, const RigidMotion& now) {
  const Vec3 spin = now.inertia.inverse() * (before.inertia * before.angular_velocity) - now.angular_velocity;
  for (const NodeId node : body.nodes)
    world.nodes.velocities[node] += spin.cross(world.nodes.positions[node] - now.center);
  add_spin_to_edges(body, spin, world.edges);
}

}  // namespace griffith
