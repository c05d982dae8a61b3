#include "sim/world/state/hash_state.h"

#include "sim/core/hash_bytes.h"

namespace griffith {
namespace {

/// Hash of numbers that are not contiguous, in their order.
class FieldHash {
 public:
  template <class T>
  FieldHash& add(const std::vector<T>& values) {
    value_ = hash_values(values, value_);
    return *this;
  }
  /// Adds counts, ids and flags.
  template <class... Whole>
  FieldHash& add_whole(Whole... values) {
    const std::array<std::int64_t, sizeof...(values)> all = {whole(values)...};
    value_ = hash_values(std::span<const std::int64_t>(all), value_);
    return *this;
  }
  template <class... Real>
  FieldHash& add_real(const Real&... values) {
    (add_one(values), ...);
    return *this;
  }
  std::uint64_t value() const { return value_; }

 private:
  template <class Number>
  static std::int64_t whole(Number number) {
    return static_cast<std::int64_t>(number);
  }
  template <class Tag>
  static std::int64_t whole(Id<Tag> id) {
    return id.index();
  }
  void add_one(double number) { value_ = hash_values(std::span<const double>(&number, 1), value_); }
  template <class Matrix>
  void add_one(const Eigen::MatrixBase<Matrix>& matrix) {
    value_ = hash_values(std::span<const double>(matrix.derived().data(), matrix.size()), value_);
  }
  void add_one(const Quat& rotation) { add_one(rotation.coeffs()); }

  std::uint64_t value_ = 0;
};

std::uint64_t hash_with_edges(const std::vector<Vec3>& of_nodes, const std::vector<Vec3>& of_edges) {
  const std::uint64_t hash = hash_values(of_nodes);
  return of_edges.empty() ? hash : hash_values(of_edges, hash);
}

std::uint64_t hash_of_mesh(const WorldState& world) {
  return FieldHash()
      .add(world.mesh->tets)
      .add(world.elements.bodies)
      .add(world.mesh->rest_positions)
      .add(world.nodes.masses)
      .value();
}

std::uint64_t hash_of_stresses(const WorldState& world) {
  const ElementArrays& elements = world.elements;
  // Strains that take no room are zero.
  const std::vector<Mat3> zeros(elements.plastic_strains.empty() ? elements.states.size() : 0, Mat3::Zero());
  FieldHash hash;
  hash.add(*elements.stresses).add(zeros.empty() ? elements.plastic_strains : zeros);
  hash.add(zeros.empty() ? elements.similarity_strains : zeros);
  if (elements.has_flowed_at_points()) hash.add(elements.point_strains);
  return hash.value();
}

std::uint64_t hash_of_separations(const WorldState& world) {
  static_assert(sizeof(NodeSeparation) == 21 * sizeof(double), "it has no padding");
  const NodeArrays& nodes = world.nodes;
  FieldHash hash;
  hash.add(nodes.separations).add(nodes.reactions).add(nodes.strength_factors).add(nodes.has_support);
  return hash.value();
}

std::uint64_t hash_of_cracks(const WorldState& world) {
  FieldHash hash;
  hash.add(*world.elements.opened)
      .add(world.mesh->neighbors)
      .add(world.nodes.at_crack_front)
      .add(world.nodes.path_offsets);
  static_assert(sizeof(OverloadHistory) == 3 * sizeof(double), "it has no padding");
  hash.add(world.nodes.pushed_at).add(world.nodes.overloads).add_real(world.overload_check);
  hash.add(world.splinter_state.open_walls).add(world.splinter_state.attached);
  hash.add_whole(world.crack_events.size());
  for (const CohesiveFace& face : world.cohesive_faces) {
    hash.add_whole(face.face.first, face.face.second);
    for (const Bond& bond : face.bonds) hash.add_real(bond.force, bond.critical, bond.opening);
  }
  for (const PostponedCrack& crack : world.postponed)
    hash.add_whole(crack.node).add_real(crack.separation.eigenvalue, crack.separation.utilization);
  return hash.value();
}

void add_body(const Body& body, FieldHash& hash) {
  const RigidMotion& motion = body.motion;
  hash.add_whole(body.id, body.parent, body.scene_body, body.tets.size(), body.rigid, body.asleep, body.quiet_steps);
  hash.add_real(motion.mass, motion.center, motion.inertia, motion.velocity, motion.angular_velocity);
  hash.add_real(body.orientation, body.explicit_ended);
  hash.add_real(body.rest.time, body.rest.place.translation, body.rest.place.rotation, body.rest.peak_utilization);
  for (const ContactLoad& load : body.known_contact_loads) hash.add_whole(load.other).add_real(load.force);
  if (body.ballistic) hash.add_whole(body.ballistic);
  hash.add_whole(body.explicit_state.has_value());
  if (const auto& explicit_state = body.explicit_state)
    hash.add_real(explicit_state->last_event, explicit_state->impact_speed, explicit_state->frequency,
                  explicit_state->similarity);
}

/// Adds a grab or a push.
void add_input(const PlacedLoad& placed, FieldHash& hash) {
  hash.add_whole(placed.point->tet).add_real(placed.point->weights, placed.load.force, placed.load.start);
  if (!placed.spring) return;
  const auto& [target, spring, position, velocity, time] = *placed.spring;
  hash.add_real(target, position, velocity, time, spring.frequency, spring.damping_ratio, spring.strength);
}

std::uint64_t hash_of_bodies(const WorldState& world) {
  FieldHash hash;
  for (const Body& body : world.bodies) add_body(body, hash);
  for (const PlacedLoad& placed : world.loads)
    if (placed.point) add_input(placed, hash);
  hash.add(world.nodes.similarity_starts).add_real(world.last_microstep_work, world.explicit_overhead);
  return hash.value();
}

std::uint64_t hash_of_projectiles(const WorldState& world) {
  FieldHash hash;
  for (const Projectile& projectile : world.projectiles) {
    const RigidState state = world.contact_world.state(projectile.object);
    hash.add_real(projectile.mass, projectile.radius, state.pose.translation, state.pose.rotation, state.velocity,
                  state.angular_velocity);
  }
  for (const PendingShot& shot : world.pending_shots) hash.add_real(shot.time, shot.burst.position, shot.burst.speed);
  return hash.value();
}

std::uint64_t hash_of_energy(const WorldState& world) {
  FieldHash hash;
  for (const EnergyEntry& entry : energy_entries()) hash.add_real(world.energy.*entry.value);
  return hash.value();
}

/// Hash functions in the order of kStateFields.
constexpr std::array<std::uint64_t (*)(const WorldState&), kStateFields.size()> kHashes = {
    [](const WorldState& world) { return hash_with_edges(world.nodes.positions, world.edges.offsets); },
    [](const WorldState& world) { return hash_with_edges(world.nodes.velocities, world.edges.velocities); },
    hash_of_mesh,
    hash_of_stresses,
    hash_of_separations,
    hash_of_cracks,
    hash_of_bodies,
    hash_of_projectiles,
    [](const WorldState& world) { return world.contact_world.memory_hash(); },
    hash_of_energy,
};

}  // namespace

StateHashes hash_state(const WorldState& world) {
  StateHashes hashes = {};
  for (std::size_t field = 0; field < hashes.size(); ++field) hashes[field] = kHashes[field](world);
  return hashes;
}

}  // namespace griffith
