#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/shock/element_block.h"
#include "sim/shock/quadratic_block.h"
#include "sim/solver/node_constraint.h"

namespace griffith::shock {

/// What the microsteps know of a node beside where it is.
struct SolidNode {
  double inverse_mass = 0;                                   ///< [1/kg]
  int first = 0, count = 0;                                  ///< its part of the list of stars
  int constraint = -1;                                       ///< index into Solid::constraints(), or -1
  float threshold = std::numeric_limits<float>::infinity();  ///< [Pa]; see Solid::advance()
};

/// A node that a support holds in some directions.
struct SolidConstraint {
  int node = 0;
  NodeConstraint constraint;
  Vec3 before = Vec3::Zero();   ///< velocity of the node in the blocked directions before the next reaction [m/s]
  Vec3 impulse = Vec3::Zero();  ///< of the support on the node so far [N·s]
  double work = 0;              ///< of the support as it moves [J]

  void take(const Vec3& reaction) {
    impulse += reaction;
    work += 0.5 * reaction.dot(before + constraint.velocity);
    before = constraint.velocity;
  }
};

/// What moves in the microsteps.
struct SolidNodeStart {
  Vec3 reference = Vec3::Zero();     ///< place without deformation, in the body's present turn [m]
  Vec3 displacement = Vec3::Zero();  ///< from there [m]
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< by external forces [m/s²]
  double mass = 0;                   ///< [kg], > 0
};

/// What the microsteps know of an edge of quadratic tets beside its offset.
struct SolidEdge {
  double inverse_mass = 0;          ///< [1/kg]
  int first = 0, count = 0;         ///< its part of the list of stars
  Mat3 allowed = Mat3::Identity();  ///< projector onto what supports leave it
  bool is_free = true;
};

/// An edge that moves in the microsteps: by how far its middle is from the middle of its ends.
struct SolidEdgeStart {
  Vec3 offset = Vec3::Zero();       ///< [m]
  Vec3 velocity = Vec3::Zero();     ///< of the offset [m/s]
  double mass = 0;                  ///< [kg], > 0
  Mat3 allowed = Mat3::Identity();  ///< see NodeConstraint
};

/// One body of the solid.
struct SolidBody {
  BlockLaw law;        ///< its viscosity follows from `damping` and the microstep
  double damping = 0;  ///< Rayleigh's β [s]
  int first_block = 0, blocks = 0;
  double frequency = 0;  ///< the highest that its elements have, after some were relieved [rad/s]
  int relieved = 0;      ///< elements that have a part of their stiffness alone, so as not to set the microstep
};

/// Highest frequency of a body with quadratic elements, each of whose edges has the mass of all tets round it; slivers
/// are not relieved [rad/s].
double highest_quadratic_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements);

/// Tetrahedral bodies under explicit dynamics: lumped masses, symplectic Euler, eight elements at a time. State is in
/// double precision, the elements' arithmetic in single precision on displacements from a placement near the present
/// one. The same bits for any number of threads.
class Solid {
 public:
  /// Nodes of a body that is added next, or by a crack. Returns its index.
  int add_node(const SolidNodeStart& start);
  /// A node that moves as another does, with its own mass [kg], for part().
  int copy_node(int node, double mass);
  /// Holds a node, or holds it otherwise from now on: a constraint may leave it free again.
  void constrain(int node, const NodeConstraint& constraint);
  /// A body of tets with these corners, seen in the body's present turn. Gradients as RestElement.
  ///   offsets   strain without stress per tet: plastic strain, in the present turn [-]
  ///   density   [kg/m³]
  ///   limit     frequency that linear elements have at most: those with a higher one are relieved of stiffness [rad/s]
  ///   edges     of quadratic tets; empty: they are linear
  void add_body(const ElasticLaw& law, double density, std::span<const std::array<int, 4>> tets,
                std::span<const RestElement> rest_elements, std::span<const Mat3> offsets,
                double limit = std::numeric_limits<double>::infinity(), std::span<const std::array<int, 6>> edges = {});
  /// Edges of a quadratic body that is added next, or by a crack; and what supports leave them from now on. As nodes.
  int add_edge(const SolidEdgeStart& start);
  int copy_edge(int edge, double mass);
  void constrain_edge(int edge, const Mat3& allowed);
  /// Once all bodies are there: stars, slots of forces, rotations.
  void finish();

  /// The stable microstep [s], the share `courant` of the limit.
  double stable_step(double courant) const;
  void set_step(double dt);

  /// Forces of all elements at the present displacements.
  void compute_forces();
  /// Moves all nodes by a microstep: velocities change by the forces over the share `kick` of it. Velocities that
  /// belong to the same time as positions take half a kick at first, and get the other half from kick() (velocity
  /// Verlet). `flagged` gets the nodes at which an element's largest principal stress exceeds the node's threshold.
  void advance(double kick, std::vector<int>& flagged);
  /// Changes velocities alone, by the forces over a share of a microstep.
  void kick(double fraction);

  /// Parts a node: stars[0] stays with it, each other one goes to a new node, which was added for it already. Entries
  /// are 4·tet + corner, ascending.
  void part(int node, std::span<const int> copies, std::span<const std::vector<int>> stars);

  /// The same for an edge; entries are edge_entry().
  void part_edge(int edge, std::span<const int> copies, std::span<const std::vector<int>> stars);
  /// Edge 0..5 of a quadratic tet in the lists of stars.
  int edge_entry(int slot, int edge) const;

  bool is_quadratic(int body) const { return quadratic_of_block_[bodies_[body].first_block] >= 0; }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  Vec3 edge_offset(int edge) const { return vector(edge_offsets_[edge].value); }
  Vec3 edge_velocity(int edge) const { return vector(edge_velocities_[edge].value); }
  SolidEdge& edge(int index) { return edges_[index]; }
  int node_count() const { return static_cast<int>(nodes_.size()); }
  int tet_slots() const { return static_cast<int>(blocks_.size()) * kLanes; }
  int body_count() const { return static_cast<int>(bodies_.size()); }
  const SolidBody& body(int index) const { return bodies_[index]; }
  int body_of_slot(int slot) const { return block_bodies_[slot / kLanes]; }
  /// The slot of a body's tet in the order in which it was added.
  int slot(int body, int tet) const { return bodies_[body].first_block * kLanes + tet; }
  SolidNode& node(int index) { return nodes_[index]; }
  const SolidNode& node(int index) const { return nodes_[index]; }
  std::span<const SolidConstraint> constraints() const { return constraints_; }
  std::span<const int> star(int node) const {
    return std::span(stars_).subspan(nodes_[node].first, nodes_[node].count);
  }
  /// Whether a tet was relieved: what it strains beyond its elastic_strain() is permanent.
  bool is_relieved(int slot) const { return stiffness(slot) < 1; }
  /// What a tet has of the law's stiffness, 0..1.
  float stiffness(int slot) const { return blocks_[slot / kLanes].stiffness[slot % kLanes]; }
  /// What of a tet's strain in the body's turn has stress under the law.
  Mat3 elastic_strain(int slot, const Mat3& strain) const;
  int corner(int slot, int corner) const { return corners_[slot][corner]; }
  /// Those of the face opposite a corner, counter-clockwise seen from outside.
  std::array<int, 3> nodes_of_side(int slot, int face) const {
    const std::array<int, 3>& corners = kTetFaces[face];
    return {corner(slot, corners[0]), corner(slot, corners[1]), corner(slot, corners[2])};
  }
  int body_of_node(int node) const { return body_of_slot(star(node).front() / 4); }

  Vec3 reference(int node) const { return vector(references_[node].value); }
  Vec3 displacement(int node) const { return vector(displacements_[node].value); }
  Vec3 position(int node) const { return vector(place(node)); }
  /// Its position, the fourth lane 0.
  WideQuad place(int node) const { return references_[node].value + displacements_[node].value; }
  Vec3 velocity(int node) const { return vector(velocities_[node].value); }
  /// Changes a node's velocity by an impulse [N·s]; where it is held, the support takes it.
  void push(int node, const Vec3& impulse);
  /// Moves a node, for a push that should have come before its last motion [m].
  void shift(int node, const Vec3& displacement) {
    displacements_[node].value += WideQuad{displacement[0], displacement[1], displacement[2], 0};
  }
  /// Adds to a node's acceleration by external forces, from now on [m/s²].
  void accelerate(int node, const Vec3& change) {
    accelerations_[node].value += WideQuad{change[0], change[1], change[2], 0};
  }
  /// The velocity change that a unit impulse along `direction` brings along it [1/kg].
  double mobility(int node, const Vec3& direction) const;
  /// What viscosity has taken [J]: half of what it does in the present forces, if these will get half a kick.
  double viscous_work() const;
  /// From now on, forces are elastic alone.
  void stop_viscosity();
  /// Energy of the change of velocities by half a kick of the present forces [J].
  double half_kick_energy() const;
  /// Acceleration of a node by external forces; by all present forces, where it is free to go [m/s²].
  Vec3 external_acceleration(int node) const { return vector(accelerations_[node].value); }
  Vec3 acceleration(int node) const;
  /// Highest speed of any node, as advance() left it [m/s].
  double fastest() const { return fastest_; }
  /// What holds the velocities of all nodes, as advance() left them [m/s].
  Eigen::AlignedBox3d velocities() const { return {vector(lowest_), vector(highest_)}; }

 private:
  struct NodeValue {
    WideQuad value = {};
  };
  struct CornerForce {
    Quad value = {};
  };
  static Vec3 vector(const WideQuad& q) { return {q[0], q[1], q[2]}; }

  void advance_nodes(double kick, double drift, std::vector<int>& flagged);
  void advance_edges(double kick, double drift);
  void hold(int constraint, double drift);
  void relieve_slivers(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements, double limit,
                       SolidBody& body);
  void add_quadratic_blocks(std::span<const std::array<int, 6>> edges, const SolidBody& body);
  void list_edge_stars();
  Vec3 edge_acceleration(int edge) const;
  QuadraticDisplacements displacements() const {
    return {&displacements_[0].value, edge_offsets_.empty() ? nullptr : &edge_offsets_[0].value};
  }

  std::vector<SolidBody> bodies_;
  std::vector<SolidNode> nodes_;
  std::vector<SolidConstraint> constraints_;
  std::vector<NodeValue> references_, displacements_, velocities_, accelerations_;
  std::vector<ElementBlock> blocks_;
  std::vector<std::array<int, 4>> corners_;  ///< per slot, those of a tet together
  std::vector<ViscousWork> viscous_works_;   ///< per block
  std::vector<int> block_bodies_;            ///< per block
  std::vector<CornerForce> forces_;          ///< 4·slot + corner
  std::vector<int> stars_;
  std::vector<int> quadratic_of_block_;     ///< per block: index into quadratics_, -1 for linear ones
  std::vector<QuadraticBlock> quadratics_;  ///< of blocks of quadratic tets
  std::vector<SolidEdge> edges_;
  std::vector<NodeValue> edge_offsets_, edge_velocities_;
  std::vector<CornerForce> edge_forces_;  ///< 6·(slot among quadratic ones) + edge
  std::vector<int> edge_stars_;
  WideQuad lowest_ = {}, highest_ = {};
  double dt_ = 0, fastest_ = 0;
};

}  // namespace griffith::shock
