#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/explicit/element_block.h"
#include "sim/explicit/quadratic_block.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/node_constraint.h"

namespace griffith::explicit_dynamics {

/// Data of a node in the microsteps besides its motion.
struct ExplicitNode {
  double inverse_mass = 0;   ///< [1/kg]
  int first = 0, count = 0;  ///< its range in the list of stars
  int constraint = -1;       ///< index into ExplicitBodies::constraints(), or -1
  float threshold =
      std::numeric_limits<float>::infinity();  ///< stress that flags the node [Pa]; see ExplicitBodies::advance()
};

/// Node that a support holds in some directions.
struct ExplicitConstraint {
  int node = 0;
  NodeConstraint constraint;
  Vec3 before = Vec3::Zero();   ///< velocity of the node in the blocked directions before the next reaction [m/s]
  Vec3 impulse = Vec3::Zero();  ///< impulse of the support on the node so far [N·s]
  double work = 0;              ///< work of the moving support [J]

  void take(const Vec3& reaction) {
    impulse += reaction;
    work += 0.5 * reaction.dot(before + constraint.velocity);
    before = constraint.velocity;
  }
};

/// Initial state of a node in the microsteps.
struct ExplicitNodeStart {
  Vec3 reference = Vec3::Zero();     ///< undeformed position, in the present rotation of the body [m]
  Vec3 displacement = Vec3::Zero();  ///< displacement from it [m]
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< acceleration by external forces [m/s²]
  double mass = 0;                   ///< [kg], > 0
};

/// Data of an edge of quadratic tets in the microsteps besides its offset; what each of them needs comes first.
struct ExplicitEdge {
  double inverse_mass = 0;   ///< [1/kg]
  int first = 0, count = 0;  ///< its range in the list of stars
  int tie = -1;              ///< its group of tied edges, or -1
  bool is_free = true;
  Vec3 acceleration = Vec3::Zero();  ///< acceleration of its offset by external forces [m/s²]
  Mat3 allowed = Mat3::Identity();   ///< projector onto directions not blocked by supports
};

/// Initial state of an edge in the microsteps: its midpoint relative to the middle of its ends.
struct ExplicitEdgeStart {
  Vec3 offset = Vec3::Zero();        ///< [m]
  Vec3 velocity = Vec3::Zero();      ///< velocity of the offset [m/s]
  double mass = 0;                   ///< [kg], > 0
  Mat3 allowed = Mat3::Identity();   ///< see NodeConstraint
  Vec3 acceleration = Vec3::Zero();  ///< acceleration of the offset by external forces [m/s²]
};

/// Body in explicit dynamics.
struct ExplicitBody {
  BlockLaw law;              ///< law whose viscosity follows from `damping` and the microstep
  double damping = 0;        ///< Rayleigh's β [s]
  float last_viscosity = 0;  ///< viscosity of the last forces [-]
  double density = 0;        ///< [kg/m³]
  int first_block = 0, blocks = 0;
  double frequency = 0;  ///< frequency that sets its microstep, after some elements were relieved [rad/s]
  int relieved = 0;      ///< number of elements of reduced stiffness, which would limit the microstep otherwise
};

/// Tetrahedral bodies under explicit dynamics: lumped masses, symplectic Euler, eight elements at a time. State is in
/// double precision, the elements' arithmetic in single precision on displacements from a placement near the present
/// one. Has the same bits for any number of threads.
class ExplicitBodies {
 public:
  /// Adds a node for the next body, or for a crack. Returns its index.
  int add_node(const ExplicitNodeStart& start);
  /// Adds a node that moves like another one, with its own mass [kg], for part().
  int copy_node(int node, double mass);
  /// Sets the constraint of a node, which may also release it.
  void constrain(int node, const NodeConstraint& constraint);
  /// Adds a body of tets with these corners, in the body's present rotation. Gradients as in RestElement.
  ///   offsets   stress-free strain per tet: plastic strain, in the present rotation [-]
  ///   density   [kg/m³]
  ///   limit     largest frequency of linear elements; the stiffness of those above it is reduced [rad/s]
  ///   edges     edges of quadratic tets; empty: they are linear
  void add_body(const ElasticLaw& law, double density, std::span<const std::array<int, 4>> tets,
                std::span<const RestElement> rest_elements, std::span<const Mat3> offsets,
                double limit = std::numeric_limits<double>::infinity(), std::span<const std::array<int, 6>> edges = {});
  /// Sets the stress-free strains at the corners of the last body's quadratic tets, in its present rotation, in place
  /// of `offsets` [-].
  void set_corner_offsets(std::span<const CornerTensors> offsets);
  /// Gives the last body the strength surface of its material, by which nodes are flagged.
  void set_strength_surface(const Material& material);
  /// Adds edges for the next quadratic body, or for a crack. Sets the directions not blocked by supports. As for nodes.
  int add_edge(const ExplicitEdgeStart& start);
  int copy_edge(int edge, double mass);
  void constrain_edge(int edge, const Mat3& allowed);
  /// Completes the data after all bodies are added: stars, slots of forces, rotations.
  void finish();

  /// Returns the stable microstep [s], the fraction `courant` of the limit.
  double stable_step(double courant) const;
  /// Sets the length of microsteps [s].
  void set_step(double dt);
  /// Changes the length of the microsteps from the next advance() on [s].
  void change_step(double dt) { dt_ = dt; }

  /// Computes the forces of all elements at the present displacements. Without their largest stresses advance() flags
  /// no nodes.
  void compute_forces(bool finds_largest = true);
  /// Moves all nodes by a microstep. Velocities change by the forces over the fraction `kick` of it. Velocities at the
  /// time of the positions take half a kick at first, and the other half from kick() (velocity Verlet). `flagged`
  /// receives the nodes at which an element's largest principal stress, or its equivalent tension, exceeds the node's
  /// threshold.
  void advance(double kick, std::vector<int>& flagged);
  /// Changes only velocities, by the forces over a fraction of a microstep.
  void kick(double fraction);

  /// Separates a node: stars[0] stays with it, each other one goes to a new node, which was added before. Entries are
  /// 4·tet + corner, ascending.
  void part(int node, std::span<const int> copies, std::span<const std::vector<int>> stars);

  /// Separates an edge likewise; entries are edge_entry().
  void part_edge(int edge, std::span<const int> copies, std::span<const std::vector<int>> stars);
  /// Raises the frequencies of quadratic bodies as their elements at nodes and edges parted since the last call
  /// request: less mass moves with each. Returns true if one was raised.
  bool raise_frequencies();
  /// Ties pairs of edges from now on, and releases all others. Edges that pairs connect move alike, with the mean of
  /// their momentum. Returns the kinetic energy that this takes [J], 0 if they moved alike before.
  double tie_edges(std::span<const std::pair<int, int>> pairs);
  /// Returns the entry of edge 0..5 of a quadratic tet in the lists of stars.
  int edge_entry(int slot, int edge) const;
  /// Returns the edge between two corners of a quadratic tet.
  int edge_between(int slot, int corner, int other) const;

  bool has_edges() const { return !edges_.empty(); }
  bool is_quadratic(int body) const { return quadratic_of_block_[bodies_[body].first_block] >= 0; }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  Vec3 edge_offset(int edge) const { return vector(edge_offsets_[edge].value); }
  Vec3 edge_velocity(int edge) const { return vector(edge_velocities_[edge].value); }
  ExplicitEdge& edge(int index) { return edges_[index]; }
  const ExplicitEdge& edge(int index) const { return edges_[index]; }
  int node_count() const { return static_cast<int>(nodes_.size()); }
  int tet_slots() const { return static_cast<int>(blocks_.size()) * kLanes; }
  int body_count() const { return static_cast<int>(bodies_.size()); }
  const ExplicitBody& body(int index) const { return bodies_[index]; }
  int body_of_slot(int slot) const { return block_bodies_[slot / kLanes]; }
  /// Returns the slot of a body's tet, by the order of addition.
  int slot(int body, int tet) const { return bodies_[body].first_block * kLanes + tet; }
  ExplicitNode& node(int index) { return nodes_[index]; }
  const ExplicitNode& node(int index) const { return nodes_[index]; }
  std::span<const ExplicitConstraint> constraints() const { return constraints_; }
  std::span<const int> star(int node) const {
    return std::span(stars_).subspan(nodes_[node].first, nodes_[node].count);
  }
  /// True if a tet was relieved: its strain beyond elastic_strain() is permanent.
  bool is_relieved(int slot) const { return stiffness(slot) < 1; }
  /// Returns the fraction of the law's stiffness of a tet, 0..1.
  float stiffness(int slot) const { return blocks_[slot / kLanes].stiffness[slot % kLanes]; }
  /// Returns the part of a tet's strain in the body's rotation that has stress under the law.
  Mat3 elastic_strain(int slot, const Mat3& strain) const;
  int corner(int slot, int corner) const { return corners_[slot][corner]; }
  /// Returns the nodes of the face opposite a corner, counterclockwise seen from outside.
  std::array<int, 3> nodes_of_side(int slot, int face) const {
    const std::array<int, 3>& corners = kTetFaces[face];
    return {corner(slot, corners[0]), corner(slot, corners[1]), corner(slot, corners[2])};
  }
  int body_of_node(int node) const { return body_of_slot(star(node).front() / 4); }

  Vec3 reference(int node) const { return vector(references_[node].value); }
  Vec3 displacement(int node) const { return vector(displacements_[node].value); }
  Vec3 position(int node) const { return vector(place(node)); }
  /// Returns the position of a node; the fourth lane is 0.
  WideQuad place(int node) const { return references_[node].value + displacements_[node].value; }
  Vec3 velocity(int node) const { return vector(velocities_[node].value); }
  /// Changes a node's velocity by an impulse [N·s]. Supports take the blocked components.
  void push(int node, const Vec3& impulse);
  /// Moves a node [m], for an impulse that belongs before its last motion.
  void shift(int node, const Vec3& displacement) { displacements_[node].value += wide(displacement); }
  /// Adds to an edge's lasting acceleration by external forces [m/s²].
  void accelerate_edge(int edge, const Vec3& change) { edges_[edge].acceleration += change; }
  /// Adds to a node's lasting acceleration by external forces [m/s²].
  void accelerate(int node, const Vec3& change) { accelerations_[node].value += wide(change); }
  /// Returns the displacement in `time` [s] by the velocity change of an impulse [N·s], in the directions that supports
  /// leave free [m].
  Vec3 displacement_by(int node, const Vec3& impulse, double time) const;
  /// Returns the velocity change along `direction` of a unit impulse along it [1/kg].
  double mobility(int node, const Vec3& direction) const;
  /// Returns the energy dissipated by viscosity [J], with half of the present forces' part if these get half a kick.
  double viscous_work() const;
  /// Makes later forces purely elastic.
  void stop_viscosity();
  /// Returns the energy of the change of velocities by half a kick of the present forces [J].
  double half_kick_energy() const;
  /// Return a node's acceleration by external forces, and by all present forces in free directions [m/s²].
  Vec3 external_acceleration(int node) const { return vector(accelerations_[node].value); }
  Vec3 acceleration(int node) const;
  /// Returns the stress by which advance() flags a node [Pa], after compute_forces() with largest stresses.
  float flagging_stress(int node) const;
  /// Returns the last force of an element on a corner, by 4·slot + corner [N].
  Vec3 force(int entry) const {
    const Quad& force = forces_[entry].value;
    return {force[0], force[1], force[2]};
  }
  /// Returns the highest speed of any node after advance() [m/s].
  double fastest() const { return fastest_; }
  /// Returns the bounds of all nodes' velocities after advance() [m/s].
  Eigen::AlignedBox3d velocities() const { return {vector(lowest_), vector(highest_)}; }

 private:
  struct NodeValue {
    WideQuad value = {};
  };
  struct CornerForce {
    Quad value = {};
  };
  static Vec3 vector(const WideQuad& q) { return {q[0], q[1], q[2]}; }
  static WideQuad wide(const Vec3& v) { return WideQuad{v[0], v[1], v[2], 0}; }

  void follow_step();
  void advance_nodes(double kick, double drift, std::vector<int>& flagged);
  void advance_edges(double kick, double drift);
  WideQuad kick_of(const ExplicitEdge& edge, double kick) const;
  void hold(int constraint, double drift);
  void relieve_slivers(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements, double limit,
                       ExplicitBody& body);
  RestElement rest_element(int slot) const;
  int slot_of_edge_entry(int entry) const;
  double bounding_frequency(int slot) const;
  void add_quadratic_blocks(std::span<const std::array<int, 6>> edges, const ExplicitBody& body);
  void list_edge_stars();
  double move_alike(std::span<const int> tied);
  std::span<const int> tied_to(const int& edge) const;
  Vec3 common_acceleration(std::span<const int> tied) const;
  Vec3 edge_force(int edge) const;
  Vec3 edge_acceleration(int edge) const;
  QuadraticDisplacements displacements() const {
    return {&displacements_[0].value, edge_offsets_.empty() ? nullptr : &edge_offsets_[0].value};
  }

  std::vector<ExplicitBody> bodies_;
  std::vector<ExplicitNode> nodes_;
  std::vector<ExplicitConstraint> constraints_;
  std::vector<NodeValue> references_, displacements_, velocities_, accelerations_;
  std::vector<ElementBlock> blocks_;
  std::vector<std::array<int, 4>> corners_;  ///< corners per slot, those of a tet together
  std::vector<ViscousWork> viscous_works_;   ///< per block
  std::vector<int> block_bodies_;            ///< per block
  std::vector<CornerForce> forces_;          ///< forces by 4·slot + corner
  std::vector<int> stars_;
  std::vector<int> quadratic_of_block_;     ///< per block: index into quadratics_, -1 for linear ones
  std::vector<int> block_of_quadratic_;     ///< per block of quadratic tets
  std::vector<QuadraticBlock> quadratics_;  ///< data of blocks of quadratic tets
  std::vector<ExplicitEdge> edges_;
  std::vector<std::vector<int>> ties_;  ///< groups of edges that move alike
  std::vector<NodeValue> edge_offsets_, edge_velocities_;
  std::vector<CornerForce> edge_forces_;  ///< forces by 6·(slot among quadratic ones) + edge
  std::vector<int> edge_stars_;
  std::vector<int> parted_;  ///< slots of quadratic tets at nodes and edges parted since raise_frequencies()
  WideQuad lowest_ = {}, highest_ = {};
  double dt_ = 0, fastest_ = 0;
};

}  // namespace griffith::explicit_dynamics
