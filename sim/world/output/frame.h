#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/linear_algebra.h"
#include "sim/elasticity/element.h"
#include "sim/elasticity/material.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/fracture/crack_event.h"
#include "sim/fracture/node_separation.h"
#include "sim/fracture/scaled_impact.h"
#include "sim/fracture/strength_variation.h"
#include "sim/mesh/tet_edges.h"
#include "sim/solver/node_constraint.h"
#include "sim/splinters/splinters.h"
#include "sim/world/energy/energy_account.h"
#include "sim/world/output/probes.h"
#include "sim/world/setup/element_choice.h"

namespace griffith {

/// Connected piece.
struct BodyView {
  BodyId id, parent;   ///< parent: the body that it broke off, invalid for an original
  int scene_body = 0;  ///< index into Scene::bodies of its origin
  int tets = 0;
  double mass = 0;  ///< [kg]
  Vec3 center_of_mass, velocity, angular_velocity;
  Quat orientation = Quat::Identity();                 ///< rotation from its first shape
  std::span<const std::vector<Vec3>> collision_parts;  ///< corners of the convex parts, in the body's own frame [m]
  bool supported = false;                              ///< has nodes held in place
  bool rigid = false;                  ///< moves as a whole: its stress is not computed until something strikes it
  bool asleep = false;                 ///< lies still until something strikes it
  std::optional<ScaledImpact> scaled;  ///< present if its waves took more microsteps than the budget allowed
  /// Scaled material in which it, or a body from which it broke off, cracked: the one of the smallest f. Permanent.
  std::optional<ScaledImpact> broke_scaled;
};

/// Contact between two objects near one place in the last step.
struct ContactView {
  BodyId a, b;                   ///< invalid: a projectile or the ground
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 normal = Vec3::UnitY();   ///< unit, from b to a
  Vec3 impulse = Vec3::Zero();   ///< on a, over all substeps [N·s]
  double depth = 0;              ///< deepest overlap there when it acted, >= 0 [m]
  double approach = 0;           ///< greatest speed at which the gap was closing before an impulse [m/s]
};

struct ProjectileView {
  Vec3 position, velocity;
  Quat rotation;
  double radius = 0, mass = 0;              ///< radius of a sphere, or of the one around it [m], [kg]
  std::span<const Vec3> corners;            ///< corners of a convex projectile, in its own frame [m]; none for a sphere
  std::span<const std::vector<int>> faces;  ///< convex polygons of corners, counter-clockwise from outside
};

/// Milliseconds of the phases of one step; for display and statistics, never for decisions.
struct StepTimings {
  double step = 0, contact = 0, elasticity = 0, explicit_dynamics = 0, separation = 0, fracture = 0;
};

/// Report of a step: every limit that was reached and every number that went wrong is counted here.
struct StepReport {
  int substeps = 1;
  int microsteps = 0;         ///< number of microsteps of bodies in explicit dynamics
  double microstep_work = 0;  ///< work of microsteps, counted, not timed [ms of a typical core]
  int contacts = 0;
  double peak_utilization = 0;       ///< highest utilization of any node in any substep
  int impacts = 0;                   ///< bodies that something struck so hard that waves run in them since
  int cracks = 0;                    ///< nodes split
  int cracks_postponed = 0;          ///< over the budget at the step's end, carried to the next one
  int cracks_suppressed = 0;         ///< not made: the fragment would have been too small
  int remeshing_refused = 0;         ///< edges not cut: tets would have been too small or too flat
  int supports_torn = 0;             ///< cracks at which a support lost its hold
  int unfinished_equilibria = 0;     ///< static steps in which cracks were still opening at the limit of substeps
  int unfinished_explicit = 0;       ///< bodies left to the implicit step, waves still running: too much work
  int relieved_tets = 0;             ///< most at a time that kept a part of their stiffness alone in microsteps
  int solver_iterations = 0;         ///< most in any body and substep
  double max_relative_residual = 0;  ///< largest in any body and substep
  int unconverged_solves = 0;        ///< stopped by the iteration limit
  int inverted_tets = 0;
  int unconverged_motions = 0;   ///< deformations of bodies whose nonlinear step did not converge
  int unconverged_contacts = 0;  ///< contacts of elastic bodies that did not meet their law within the tolerance
  int contact_iterations = 0;    ///< iterations of the linear systems of their impulses, in total
  int sleeping_bodies = 0;
  int non_finite_values = 0;   ///< bodies frozen because a value was not finite or substeps too short
  double max_penetration = 0;  ///< [m]
  StepTimings milliseconds;
};

/// Grab of a piece by a spring.
struct GrabView {
  BodyId body;
  Vec3 point = Vec3::Zero(), target = Vec3::Zero();  ///< ends of the spring [m]
  Vec3 force = Vec3::Zero();                         ///< force on the piece in the last substep [N]
  double max_force = 0;                              ///< [N]
};

/// Sums over everything that moves (bodies and projectiles), SI units.
struct Totals {
  double mass = 0, kinetic_energy = 0, elastic_energy = 0;
  Vec3 momentum = Vec3::Zero(), angular_momentum = Vec3::Zero();  ///< about the world's origin
};

/// Result of a step: views of the world's arrays, valid until the next step.
struct Frame {
  /// Per node of the mesh.
  struct Nodes {
    std::span<const Vec3> rest_positions, positions;  ///< [m]
    /// Indices in the mesh of their shape, as built or read, of the initial nodes of bodies, which come first.
    std::span<const int> points;
    std::span<const Vec3> velocities;              ///< [m/s]
    std::span<const double> masses;                ///< [kg]
    std::span<const std::uint8_t> has_support;     ///< 1 where a support acts on it
    std::span<const NodeConstraint> constraints;   ///< constraints by supports
    std::span<const Vec3> load_forces;             ///< present forces of loads on it [N]; empty without loads
    std::span<const std::uint8_t> at_crack_front;  ///< 1 where cut faces end
    std::span<const NodeSeparation> separations;
    std::span<const Vec3> reactions;            ///< reactions of supports in the last step [N]
    std::span<const std::vector<TetId>> stars;  ///< its tets, ascending
  };
  /// Per tet of the mesh.
  struct Elements {
    std::span<const std::array<NodeId, 4>> tets;      ///< corners; face i opposite corner i (kTetFaces)
    std::span<const std::array<TetId, 4>> neighbors;  ///< behind face i; invalid on the surface
    std::span<const BodyId> bodies;
    std::span<const std::uint8_t> first_surface;    ///< bit i: face i was on the surface at the start
    std::span<const std::array<double, 4>> opened;  ///< time at which a crack opened face i [s], else not a number
    std::span<const RestElement> rest_elements;
    std::span<const ElementState> states;
    std::span<const Mat3> stresses;  ///< Cauchy stress, world frame [Pa]; its mean in quadratic tets
    /// Edges of quadratic tets, ordered as kTetEdges; invalid ids for linear ones; empty: all are linear.
    std::span<const std::array<EdgeId, 6>> edges;
    std::span<const QuadraticState> quadratic_states;  ///< states of quadratic tets; empty if there are none
  };
  /// Per edge of quadratic tets.
  struct Edges {
    std::span<const std::array<NodeId, 2>> ends;
    std::span<const Vec3> offsets;  ///< displacement of its midpoint from the middle of its ends [m]
  };
  /// Splinters of bodies, drawn instead of tets.
  struct Splinters {
    std::span<const Splinter> splinters;
    std::span<const SplinterPart> parts;      ///< by splinter
    std::span<const SplinterFace> faces;      ///< by part
    std::span<const SplinterCorner> corners;  ///< by face
    std::span<const std::uint8_t> attached;   ///< per part: 1 carried by its own tet, 0 by the owner
    std::span<const int> open_walls;          ///< faces between splinters that cracks have opened
  };

  std::span<const ElementChoice> element_choices;  ///< per body of the scene
  std::int64_t step = 0;
  double time = 0;  ///< [s]
  Nodes nodes;
  Elements elements;
  Edges edges;
  Splinters splinters;
  std::span<const BodyView> bodies;                     ///< one per BodyId; bodies are never removed
  int fragments = 0;                                    ///< connected pieces beyond the scene's own bodies
  std::span<const Material> materials;                  ///< per scene body, as in force now
  std::span<const std::optional<Weakness>> weaknesses;  ///< per scene body: unit direction in the placed rest space
  std::span<const ProjectileView> projectiles;
  std::span<const ContactView> contacts;     ///< contacts of the last step with an impulse
  std::span<const CrackEvent> crack_events;  ///< all so far, oldest first
  std::optional<GrabView> grab;              ///< present grab, if any
  std::span<const PlacedProbe> probes;       ///< the scene's, to be read with probe_values()
  Totals totals;
  EnergyAccount energy, energy_of_step;  ///< since the start, and what the last step changed in it
  StepReport report;                     ///< counters
};

}  // namespace griffith
