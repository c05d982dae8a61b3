#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/fracture/strength_variation.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/solver/node_constraint.h"

namespace griffith {

/// Returns m(a) = a aᵀ / |a|, m(0) = 0 (O'Brien & Hodgins 1999, eq. 15).
Mat3 force_dyad(const Vec3& force);

/// Data of the elements around nodes for their separation.
struct SeparationInput {
  std::span<const std::array<NodeId, 4>> tets;            // per tet: corners
  std::span<const std::vector<TetId>> stars;              // per node: its tets
  std::span<const RestElement> rest_elements;             // per tet
  std::span<const ElementState> states;                   // per tet
  std::span<const NodeConstraint> constraints;            // per node; empty: all are free
  std::span<const std::array<EdgeId, 6>> edges = {};      // per tet; invalid for linear ones; empty: all are linear
  std::span<const QuadraticState> quadratic_states = {};  // per tet; used for quadratic ones

  /// Returns the states of a quadratic tet's corners; null for a linear one.
  const std::array<ElementState, 4>* corner_states(TetId tet) const {
    return !edges.empty() && edges[tet][0].valid() ? &quadratic_states[tet].corners : nullptr;
  }
  /// Returns the state of a tet at one of its corners, equal at all of a linear one.
  const ElementState& state_at(TetId tet, int corner) const {
    const std::array<ElementState, 4>* corners = corner_states(tet);
    return corners ? (*corners)[corner] : states[tet];
  }
};
bool is_constrained(const SeparationInput& input, NodeId node);
/// True if a support holds all corners of a tet.
bool is_anchored(const SeparationInput& input, TetId tet);

/// Forces of an element on one of its nodes, world frame [N].
struct SplitForce {
  Vec3 tensile = Vec3::Zero(), compressive = Vec3::Zero();  ///< f_e⁺, f_e⁻
};
SplitForce split_force(const RestElement& rest, const ElementState& state, int corner);
SplitForce split_force(const SeparationInput& input, TetId tet, NodeId node);

/// Returns the separation tensor of a node in the world frame [N] (O'Brien & Hodgins 1999, eq. 16):
///   ς = ½ ( −m(f⁺) + Σ m(f_e⁺) + m(f⁻) − Σ m(f_e⁻) )
///   f_e⁺, f_e⁻  tensile and compressive force of element e on the node, f⁺, f⁻ their sums
/// At a constrained node the reaction is missing from the sums, so both terms of the sums are omitted: a support gives
/// no protection.
Mat3 separation_tensor(const SeparationInput& input, NodeId node);

/// Plane across which a node would separate, and the tension across it.
struct CandidatePlane {
  Vec3 normal = Vec3::UnitX();  ///< unit normal n̂, world frame
  double eigenvalue = 0;        ///< v⁺ = n̂·ς n̂ [N]: the largest eigenvalue of ς if the strength is uniform
  double stress = 0;            ///< separation stress s [Pa], independent of the mesh
  bool by_tension = false;      ///< true if s is that of the mean tensile stress, else it is v⁺ per area
  Vec3 pulled = Vec3::UnitX();  ///< unit normal of the plane of v⁺: n̂ unless by_tension
  double volume = 0;            ///< volume of the elements that count [m³]
};

/// Returns the plane with the largest load relative to the `strength` of its direction, n·ς n / n·T n. The stress
/// across it is the larger of s = n·ς n / A, with A = ½ Σ_e V_e |(cof(B) g_e)·e| and e the eigenvector of v⁺, and that
/// of the volume-averaged tensile stress, which then determines the plane. This makes the onset exact in multiaxial
/// tension. The stress is at most the largest tensile stress (Frobenius norm) of the node's elements. Elements with all
/// corners held by a support belong to the anchor and do not count.
CandidatePlane candidate_plane(const SeparationInput& input, NodeId node, const Mat3& tensor,
                               const DirectionalStrength& strength = {});

/// Input of a candidate plane: sums over the elements around its node. Except for the tensor, only elements that count
/// are included.
struct NodeLoad {
  Mat3 tensor = Mat3::Zero();   ///< ς, world frame [N]
  LargestPrincipal pulled;      ///< v⁺ [N] and its direction e
  double area = 0;              ///< A [m²]
  double volume = 0;            ///< [m³]
  double largest = 0;           ///< largest tensile stress of an element, Frobenius norm [Pa]
  Mat3 tension = Mat3::Zero();  ///< sum of volume times tensile stress [J]
};
/// Returns the loads of up to four `nodes`, not none. Spare places repeat the last one.
std::array<NodeLoad, 4> node_loads(const SeparationInput& input, std::span<const NodeId> nodes);
/// Returns the planes of four nodes side by side, with the bits of one at a time.
std::array<CandidatePlane, 4> candidate_planes(const std::array<NodeLoad, 4>& loads,
                                               const std::array<DirectionalStrength, 4>& strengths);

/// Returns the contribution of an element to the mean tensile stress across a plane of its node [Pa]. The contributions
/// of all elements sum to the stress.
double tension_fraction(const SeparationInput& input, TetId tet, NodeId node, const CandidatePlane& plane);

/// Returns the strength of a body with that weakness (unit direction, in rest space) for the present orientation of the
/// node's elements.
DirectionalStrength strength_at(const SeparationInput& input, NodeId node, const Weakness& weakness);

}  // namespace griffith
