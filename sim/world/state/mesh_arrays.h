#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/core/copy_on_write.h"
#include "sim/elasticity/element.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/fracture/node_separation.h"
#include "sim/mesh/bisect.h"
#include "sim/mesh/tet_edges.h"
#include "sim/solver/node_constraint.h"

namespace griffith {

/// Times of a node's overload in the checks of microsteps. −∞: never.
struct OverloadHistory {
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  double known_from = kNever;  ///< a crack beside it changes its stress until then [s]
  double since = kNever;       ///< first of the checks in a row that found it overloaded [s]
  double last = kNever;        ///< last check that found it overloaded [s]
};

/// State of nodes. Each array has an entry in each_array(), through which nodes are added.
struct NodeArrays {
  std::vector<Vec3> positions, velocities;   ///< [m], [m/s]
  std::vector<double> masses;                ///< lumped: a quarter of each tet of the star [kg]
  std::vector<NodeConstraint> constraints;   ///< constraints by supports
  std::vector<std::uint8_t> has_support;     ///< 1 where a support acts on the node
  std::vector<std::uint8_t> at_crack_front;  ///< 1 where cut faces end
  std::vector<Vec3> path_offsets;            ///< from a node at a crack front to the crack's path, at rest [m]
  std::vector<double> strength_factors;      ///< factors of flaws on the strength [-]; 1 without scatter
  std::vector<int> rows;                     ///< row in the system of the node's body, -1 for held ones
  std::vector<NodeSeparation> separations;
  std::vector<Vec3> reactions;          ///< reactions of supports in the last step [N]
  std::vector<Vec3> similarity_starts;  ///< initial displacement from rest, of bodies in explicit dynamics with f < 1
  std::vector<double> pushed_at;  ///< time of the last impulse at speed on it in explicit dynamics [s]; −∞: never
  std::vector<OverloadHistory> overloads;

  /// Makes room for as many nodes; new ones are at the origin, at rest and without mass.
  void resize(std::size_t count);
  /// Appends a node like another one. Its constraints, its place at the crack front and its row are set by others.
  void append_copy(NodeId original);
  /// Appends the node on an edge that was bisected.
  void append_between(const EdgeNode& node);
  /// Returns the size of the arrays [bytes].
  std::size_t memory() const;

  /// Calls use(all.array, what a new node has there) for every array of `all`.
  template <class Arrays, class Use>
  static void each_array(Arrays&& all, Use use) {
    const Vec3 zero = Vec3::Zero();
    use(all.positions, zero), use(all.velocities, zero), use(all.masses, 0.0), use(all.constraints, NodeConstraint());
    use(all.has_support, std::uint8_t{0}), use(all.at_crack_front, std::uint8_t{0}), use(all.path_offsets, zero);
    use(all.strength_factors, 1.0), use(all.rows, -1);
    use(all.separations, NodeSeparation()), use(all.reactions, zero), use(all.similarity_starts, zero);
    use(all.pushed_at, -std::numeric_limits<double>::infinity()), use(all.overloads, OverloadHistory());
  }
};

/// State of the edges of quadratic bodies besides that of nodes (TetEdges).
struct EdgeArrays {
  std::vector<Vec3> offsets, velocities;  ///< displacement of the midpoint, its rate [m], [m/s]
  std::vector<double> masses;             ///< mass of the tets around it: see edge_mass() [kg]
  std::vector<int> rows;                  ///< row in the system of the edge's body, -1 for held ones

  /// Makes room for as many edges; new ones are straight, at rest and without mass.
  void resize(std::size_t count);
  /// Appends an edge of bisected tets.
  void append_part(const EdgePart& part);
  /// Appends an edge like another one.
  void append_copy(EdgeId original);
  /// Returns the size of the arrays [bytes].
  std::size_t memory() const { return offsets.size() * (2 * sizeof(Vec3) + sizeof(double) + sizeof(int)); }
};

/// Times at which a crack opened each face of a tet [s]; not a number: never.
using OpenedFaces = std::array<double, 4>;
constexpr double kNeverOpened = std::numeric_limits<double>::quiet_NaN();

/// State of tets. Rest elements change only by remeshing. Each array except those of strains has an entry in
/// each_array(), through which tets are added.
struct ElementArrays {
  SharedArray<RestElement> rest_elements;
  SharedArray<ElementState> states;
  SharedArray<Mat3> stresses;  ///< Cauchy stress, world frame [Pa], for the frame
  std::vector<BodyId> bodies;
  SharedArray<std::uint8_t> first_surface;  ///< bit i: face i was on the surface before anything broke
  SharedArray<OpenedFaces> opened;

  SharedArray<QuadraticState> quadratic_states;  ///< states of quadratic tets; empty if there are none

  /// Strains without stress; empty until allow_strains(): in most bodies they would all be zero.
  std::vector<Mat3> plastic_strains;     ///< in rest space, traceless [-]
  std::vector<Mat3> similarity_strains;  ///< scaled bodies' strain beside the plastic one [-]
  /// Plastic strains at the integration points of quadratic tets, beside the one of the whole, in rest space, traceless
  /// [-]; empty until allow_point_strains().
  std::vector<CornerTensors> point_strains;

  /// Makes room for strains: before a body enters explicit dynamics, or where a material yields.
  void allow_strains();
  /// Makes room for those of integration points: where a quadratic body yields.
  void allow_point_strains();
  Mat3 plastic_strain(TetId tet) const { return plastic_strains.empty() ? Mat3(Mat3::Zero()) : plastic_strains[tet]; }
  /// Returns the strain of an element without stress: the plastic strain and that of scaling [-].
  Mat3 stress_free_strain(TetId tet) const {
    return plastic_strains.empty() ? Mat3(Mat3::Zero()) : Mat3(plastic_strains[tet] + similarity_strains[tet]);
  }
  /// Returns the strains without stress at the corners of a quadratic tet, which is not scaled [-].
  CornerTensors corner_stress_free_strains(TetId tet) const;

  /// Sets plastic strains that are no numbers to zero.
  void remove_undefined_strains(TetId tet);
  /// True if any strain of integration points is not zero.
  bool has_flowed_at_points() const;

  /// Stops sharing states and stresses with copies. Call it before several threads write them.
  void own_states() { states.edit(), stresses.edit(), quadratic_states.edit(); }
  /// Makes room for as many tets; new ones have no stress and belong to no body.
  void resize(std::size_t count);
  /// Appends a tet like another one.
  void append_copy(TetId original);
  /// Gives the halves of a bisected tet the plastic strains that the field of the whole has in them; `weight`: place of
  /// the new node on the edge. The child is like the tet.
  void share_point_strains(const TetBisection& halves, double weight);
  /// Returns the size of the arrays, without those shared with `beside` [bytes].
  std::size_t memory(const ElementArrays* beside = nullptr) const;

  template <class Arrays, class Use>
  static void each_array(Arrays&& all, Use use) {
    const Mat3 zero = Mat3::Zero();
    use(all.rest_elements, RestElement{Corners::Zero(), 0}), use(all.states, ElementState()), use(all.stresses, zero);
    use(all.bodies, BodyId()), use(all.first_surface, std::uint8_t{0});
    use(all.opened, OpenedFaces{kNeverOpened, kNeverOpened, kNeverOpened, kNeverOpened});
  }
};

/// Returns the strains without stress at the corners of quadratic tets, after their rest space has turned [-].
std::vector<CornerTensors> turned_strains(const ElementArrays& elements, std::span<const TetId> tets, const Mat3& turn);

}  // namespace griffith
