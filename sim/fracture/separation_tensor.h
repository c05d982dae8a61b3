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

/// m(a) = a aᵀ / |a|, m(0) = 0 (O'Brien & Hodgins 1999, eq. 15).
Mat3 force_dyad(const Vec3& force);

/// What the elements round a node contribute to its separation.
struct SeparationInput {
  std::span<const std::array<NodeId, 4>> tets;            // per tet: corners
  std::span<const std::vector<TetId>> stars;              // per node: its tets
  std::span<const RestElement> rest_elements;             // per tet
  std::span<const ElementState> states;                   // per tet
  std::span<const NodeConstraint> constraints;            // per node; empty: all are free
  std::span<const std::array<EdgeId, 6>> edges = {};      // per tet; invalid in linear ones; empty: all are
  std::span<const QuadraticState> quadratic_states = {};  // per tet, of quadratic ones

  /// The states of a quadratic tet's corners; null for a linear one.
  const std::array<ElementState, 4>* corner_states(TetId tet) const {
    return !edges.empty() && edges[tet][0].valid() ? &quadratic_states[tet].corners : nullptr;
  }
  /// The state of a tet at one of its corners: everywhere the same in a linear one.
  const ElementState& state_at(TetId tet, int corner) const {
    const std::array<ElementState, 4>* corners = corner_states(tet);
    return corners ? (*corners)[corner] : states[tet];
  }
};
bool is_constrained(const SeparationInput& input, NodeId node);
/// Whether a support holds a tet at all corners.
bool is_anchored(const SeparationInput& input, TetId tet);

/// What an element does to one of its nodes, world frame [N].
struct SplitForce {
  Vec3 tensile = Vec3::Zero(), compressive = Vec3::Zero();  ///< f_e⁺, f_e⁻
};
SplitForce split_force(const RestElement& rest, const ElementState& state, int corner);
SplitForce split_force(const SeparationInput& input, TetId tet, NodeId node);

/// The separation tensor of a node in the world frame [N] (O'Brien & Hodgins 1999, eq. 16):
///   ς = ½ ( −m(f⁺) + Σ m(f_e⁺) + m(f⁻) − Σ m(f_e⁻) )
///   f_e⁺, f_e⁻  tensile and compressive force of element e on the node, f⁺, f⁻ their sums
/// At a constrained node the reaction is missing from the sums, so both total terms are left out: a support is no
/// shield.
Mat3 separation_tensor(const SeparationInput& input, NodeId node);

/// The plane across which a node would separate, and what pulls there.
struct CandidatePlane {
  Vec3 normal = Vec3::UnitX();  ///< n̂, unit length, world frame
  double eigenvalue = 0;        ///< v⁺ = n̂·ς n̂ [N]: with uniform strength the largest eigenvalue of ς
  double stress = 0;            ///< s [Pa], whatever the mesh
  bool by_tension = false;      ///< s is that of the mean tensile stress, else it is v⁺ per area
  Vec3 pulled = Vec3::UnitX();  ///< unit normal of the plane that v⁺ pulls at: n̂ unless by_tension
  double volume = 0;            ///< of the elements that count [m³]
};

/// The plane on which the load is largest against the `strength` of that direction, n·ς n / n·T n. The stress across it
/// is the larger of s = n·ς n / A, with A = ½ Σ_e V_e |(cof(B) g_e)·e| and e the eigenvector of v⁺, and that of the
/// volume-averaged tensile stress, whose plane it is then: so the onset is exact in multiaxial tension. Never more than
/// the largest tensile stress (Frobenius norm) of the node's elements. Elements that a support holds at all corners are
/// part of the anchor and do not count.
CandidatePlane candidate_plane(const SeparationInput& input, NodeId node, const Mat3& tensor,
                               const DirectionalStrength& strength = {});

/// What a candidate plane follows from: sums over the elements round its node, of those that count but for the tensor.
struct StarLoad {
  Mat3 tensor = Mat3::Zero();   ///< ς, world frame [N]
  LargestPrincipal pulled;      ///< v⁺ [N] and e
  double area = 0;              ///< A [m²]
  double volume = 0;            ///< [m³]
  double largest = 0;           ///< tensile stress of an element, Frobenius norm [Pa]
  Mat3 tension = Mat3::Zero();  ///< volume times tensile stress [J]
};
/// Those of up to four `nodes`, not none; places to spare repeat the last.
std::array<StarLoad, 4> star_loads(const SeparationInput& input, std::span<const NodeId> nodes);
/// The planes of four nodes side by side, to the bits of one at a time.
std::array<CandidatePlane, 4> candidate_planes(const std::array<StarLoad, 4>& loads,
                                               const std::array<DirectionalStrength, 4>& strengths);

/// What an element adds to the mean tensile stress across a plane of its node [Pa]: all together are its stress.
double tension_fraction(const SeparationInput& input, TetId tet, NodeId node, const CandidatePlane& plane);

/// The strength of a body with that weakness (unit direction, in rest space) as its elements lie at the node now.
DirectionalStrength strength_at(const SeparationInput& input, NodeId node, const Weakness& weakness);

}  // namespace griffith
