#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// m(a) = a aᵀ / |a|, m(0) = 0 (O'Brien & Hodgins 1999, eq. 15).
Mat3 force_dyad(const Vec3& force);

/// What the elements round a node contribute to its separation.
struct SeparationInput {
  const TetMesh& mesh;
  std::span<const ElementRest> rests;    // per tet
  std::span<const ElementState> states;  // per tet
};

/// The separation tensor of a node in the world frame [N] (O'Brien & Hodgins 1999, eq. 16):
///   ς = ½ ( −m(f⁺) + Σ m(f_e⁺) + m(f⁻) − Σ m(f_e⁻) )
///   f_e⁺, f_e⁻  tensile and compressive force of element e on the node, f⁺, f⁻ their sums
/// At a `held` node the reaction is missing from the sums, so both total terms are left out.
Mat3 separation_tensor(const SeparationInput& input, NodeId node, bool held);

/// The stress that pulls a node apart across the plane with unit normal `direction` [Pa], whatever the mesh:
/// the larger of s = v⁺ / A(n̂), with A(n̂) = ½ Σ_e V_e |(cof(B) g_e)·n̂|, and the largest eigenvalue of the
/// volume-averaged tensile stress, which makes the onset exact in multiaxial tension. Where the second one is larger, `direction`
/// becomes its eigenvector. Never more than the largest tensile stress (Frobenius norm) of the node's elements.
double separation_stress(const SeparationInput& input, NodeId node, double eigenvalue, Vec3& direction);

}  // namespace griffith
