#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/core/boxed.h"
#include "sim/core/copy_on_write.h"
#include "sim/core/error.h"
#include "sim/elasticity/element.h"
#include "sim/fracture/cohesion.h"
#include "sim/fracture/node_load_sums.h"
#include "sim/geometry/convex_hull.h"
#include "sim/mesh/topology.h"
#include "sim/scene/scene.h"
#include "sim/solver/elastic_system.h"
#include "sim/solver/rigid_motion.h"
#include "sim/splinters/splinters.h"
#include "sim/world/conditions/loads.h"
#include "sim/world/conditions/supports.h"
#include "sim/world/energy/energy_account.h"
#include "sim/world/output/frame.h"
#include "sim/world/output/probes.h"
#include "sim/world/state/mesh_arrays.h"
#include "sim/world/state/microstep_watch.h"
#include "sim/world/state/model.h"

namespace griffith {

/// State of a body whose waves are followed by microsteps (explicit_run.h).
struct ExplicitState {
  double last_event = 0;    ///< time of its last impact or crack [s]
  double impact_speed = 0;  ///< speed of the impact on it [m/s]
  double frequency = 0;     ///< highest of its elements under the full stiffness, slivers relieved [rad/s]
  double similarity = 1;    ///< f (similarity.h), 0..1
  int group = 0;            ///< bodies of one group are followed together; 0: in the shared substeps
};

/// Load of another object on a body in a substep.
struct ContactLoad {
  ProxyId other;
  Vec3 force = Vec3::Zero();  ///< [N]
  double lost_in_impact = 0;  ///< energy that it took in that substep by stopping what came closer [J]
};

/// Duration of rest of a deformable body, and its state at the beginning.
struct Rest {
  double time = 0;              ///< [s]
  Pose place;                   ///< place of its center of mass
  double peak_utilization = 0;  ///< largest utilization of its nodes
};

/// Connected piece of elastic material and its proxy in the contact world.
struct alignas(64) Body {
  // What a step asks of every body, awake or not, in one line of the cache.
  std::optional<ExplicitState> explicit_state;
  BodyId id, parent;
  ProxyId proxy;
  int quiet_steps = 0;        ///< steps in a row with next to no stress
  bool rigid = false;         ///< moves as a whole: nothing about it is elastic until it is hit
  bool quasi_static = false;  ///< touches as a rigid body; its deformation follows what acts on it without waves
  bool ballistic = false;     ///< rigid for less than 20 steps in free flight: elastic once touched
  bool asleep = false;        ///< lies still, under whatever stress there is, until something disturbs it

  RigidMotion motion;                   ///< mass, momentum and inertia of the nodes now
  Quat orientation = Quat::Identity();  ///< rotation from the reference shape
  int scene_body = 0;
  std::vector<TetId> tets;    ///< ascending
  std::vector<NodeId> nodes;  ///< ascending, held ones too
  std::vector<SurfaceFace> surface;
  NodeVectors reference_arms;     ///< nodes relative to the center of mass in the last shape made [m]
  std::vector<EdgeId> edges;      ///< ascending; none of a body with linear tets
  NodeVectors reference_offsets;  ///< offsets of `edges` when it was made rigid [m]
  Boxed<ElasticSystem> system;
  std::vector<ConvexPart> collision_parts;  ///< convex parts of the proxy, for the frame [m]
  double highest_frequency = 0;             ///< [rad/s]; 0 until explicit integration asks for it
  double element_size = 0;                  ///< edge length of the cubes that six of its tets would fill, mean [m]
  bool bonded = false;                      ///< parts of it hold together by bonds of opened faces alone
  bool guided = false;                 ///< its supports let it move, otherwise than about a pivot: a hammer on rails
  bool bonds_loaded = false;           ///< contacts load its bonds: microsteps follow it from the next substep on
  double depth = 0;                    ///< volume over surface at rest, half the thickness of a plate [m]
  double extent = 0;                   ///< longest edge of the box around it at rest [m]
  double weakest_fraction = 1;         ///< fraction of its material's resistance at its weakest node and plane [-]
  std::optional<ScaledImpact> scaled;  ///< record of the last step, if any
  std::vector<ContactLoad> known_contact_loads;  ///< loads on a rigid body when it was found quiescent, by object
  Rest rest;                                     ///< rest of a deformable body
  double explicit_ended =
      -std::numeric_limits<double>::infinity();  ///< time at which it last left explicit dynamics [s]

  /// Same as BodyView::broke_scaled: decides nothing, so it is not hashed.
  std::optional<ScaledImpact> broke_scaled;

  bool supported() const { return !system->is_free(); }
  /// True if the step without microsteps deforms it.
  bool is_deformable() const { return !rigid && !explicit_state && !asleep; }
};

struct Projectile {
  ProxyId object;
  double radius = 0, mass = 0;             ///< radius of the sphere around it [m], [kg]
  std::shared_ptr<const ConvexHull> hull;  ///< in its own frame, for all of a burst; null for a sphere
  Mat3 inertia = Mat3::Zero();             ///< in its own frame [kg·m²]
  SurfaceProperties surface;
};

/// Shot that has not been fired yet.
struct PendingShot {
  double time = 0;  ///< [s]
  ProjectileBurst burst;
  Projectile projectile;  ///< without an object yet
};

/// Overloaded node that the budget left whole, with its separation at that time.
struct PostponedCrack {
  NodeId node;
  NodeSeparation separation;
};

/// State of a rigid body at the start of a substep, and the external loads on it.
struct RigidStart {
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();  ///< external, gravity too [N], [N·m]
  bool rigid = false;                                ///< true if contacts made it elastic in the substep
  bool falls = false;                                ///< gravity acted on it: what sleeps at first is not moved by it
};

/// Temporary data of a body in a substep.
struct BodyStep {
  RigidStart start;
  double energy = 0;        ///< kinetic and elastic, when the substep began [J]
  double contact_work = 0;  ///< work of the contacts, at the velocities after it [J]
  double damped = 0;        ///< energy that the damping of the implicit step took [J]
};

/// Velocities and places at the start of a substep, for the energy account.
struct SubstepStart {
  std::vector<Vec3> velocities;            ///< per node [m/s]
  std::vector<Vec3> deforming_velocities;  ///< per node, after contacts, without the body's motion as a whole [m/s]
  std::vector<Vec3> edge_velocities, deforming_edge_velocities;  ///< the same per edge [m/s]
  std::vector<RigidState> projectiles;                           ///< per projectile
};

/// Temporary data of a step.
struct Scratch {
  SubstepStart substep_start;
  std::vector<BodyStep> bodies;                ///< by BodyId, from record_substep_start() on
  double microstep_work = 0;                   ///< work of the step so far, in microseconds of a typical core
  std::vector<NodeLoadSums> node_load_sums;    ///< per node: what separation follows from
  std::vector<simd::WideQuad> elastic_forces;  ///< per node, in the first three lanes [N]
  std::vector<Vec3> edge_forces;               ///< per edge [N]
  std::vector<Vec3> edge_loads;                ///< external forces per edge in the substep [N]
  std::vector<TangentStiffness> tangents;      ///< per tet, of bodies that strain far
  std::vector<Vec3> contact_impulses;          ///< per node of elastic bodies, in the substep, bonds too [N·s]
  std::vector<HeldNode> held_nodes;            ///< held_nodes() while separations are evaluated, if bonds count
  std::vector<BodyId> bonds_broke_in;          ///< bodies that may have come apart in the substep

  Scratch() = default;
  Scratch(Scratch&&) = default;
  Scratch& operator=(Scratch&&) = default;
  /// Copies of a world stand between steps.
  Scratch(const Scratch&) {}
  Scratch& operator=(const Scratch&) { return *this = Scratch(); }
};

/// Output of a step for the frame, besides the state itself.
struct StepOutput {
  std::vector<BodyView> bodies;  ///< by BodyId
  std::vector<ProjectileView> projectiles;
  std::vector<ContactView> contacts;
  std::vector<Vec3> load_forces;  ///< per node [N]; empty without loads
  Totals totals;
};

/// State of a world between two steps, a value: a copy continues with the same bits as the original.
struct WorldState {
  explicit WorldState(std::shared_ptr<const Model> set_up)
      : model(std::move(set_up)), contact_world(model->scene.gravity) {}

  std::shared_ptr<const Model> model;
  std::vector<Material> materials;  ///< per scene body, as in force now
  std::vector<PlacedSupport> supports;
  std::vector<PlacedLoad> loads;
  std::vector<PlacedProbe> probes;  ///< as Scene::probes
  CopyOnWrite<TetMesh> mesh;
  NodeArrays nodes;
  ElementArrays elements;
  CopyOnWrite<TetEdges> tet_edges;  ///< edges of quadratic bodies
  EdgeArrays edges;
  SplinterState splinter_state;
  std::vector<Body> bodies;  ///< by BodyId; never removed
  ContactWorld contact_world;
  std::vector<BodyId> body_of_proxy;  ///< per ProxyId; invalid for projectiles and the ground
  std::vector<Projectile> projectiles;
  std::vector<PendingShot> pending_shots;

  std::int64_t step = 0;
  double time = 0;  ///< [s]
  std::vector<CrackEvent> crack_events;
  std::vector<PostponedCrack> postponed;
  std::vector<CohesiveFace> cohesive_faces;  ///< opened faces that hold or whose edges are tied, for full stiffness
  StepReport report;
  StepOutput output;
  EnergyAccount energy, energy_before;  ///< so far; before the present step
  double last_microstep_work = 0;       ///< Scratch::microstep_work of the last step
  double explicit_overhead = 1;  ///< work of the last substep's explicit dynamics over that of its elements alone [-]
  bool in_equilibrium = false;   ///< static analysis: the last step found it, and nothing was left to crack
  double overload_check = OverloadHistory::kNever;  ///< time of the last check for overload in microsteps [s]
  double potential_at_start = 0;  ///< potential energy of gravity, including objects launched since [J]
  Scratch scratch;
  MicrostepWatch* watch = nullptr;  ///< observes the microsteps of the present step

  bool integrates_explicitly() const { return model->scene.simulation.integrator == Integrator::explicit_; }
  /// Returns the body of a proxy; invalid for projectiles and the ground.
  BodyId body_of(ProxyId proxy) const {
    const auto index = static_cast<std::size_t>(proxy.index());
    return index < body_of_proxy.size() ? body_of_proxy[index] : BodyId();
  }
  const Material& material_of(const Body& body) const { return materials[body.scene_body]; }
};

}  // namespace griffith
