#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/fracture/separation_tensor.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Two faces that coincide at rest but are not linked: the sides of a crack or of a slit in the mesh.
struct OpenFace {
  TetId first, second;
  std::array<int, 3> first_corners{};   ///< corners of `first`, counterclockwise seen from outside it
  std::array<int, 3> second_corners{};  ///< the coincident corners of `second`
};

/// Returns the face of a tet with these corners: that opposite the fourth.
inline int face_of(const std::array<int, 3>& corners) { return 6 - corners[0] - corners[1] - corners[2]; }

/// Returns the pairs of open faces around nodes that coincide at rest: one at a crack front, or all copies of one.
/// Ascending by `first`.
std::vector<OpenFace> open_faces_at(const TetMesh& mesh, std::span<const NodeId> nodes);

/// Returns a third of the area vector of a face at rest, out of `tet` [m²].
Vec3 third_of_face(const TetMesh& mesh, TetId tet, const std::array<int, 3>& corners);

/// Returns for each tet of a node's star whether it lies on the side of the plane to which `normal` points (1) or not
/// (0): by its centroid; beside open faces, by the side of the crack that it belongs to, so that the crack goes on from
/// these faces.
///   star    corners of the star's tets as they are now [m]
///   offset  from the node to a point of the crack's path [m]: the plane goes through that point unless the star lies
///           on one side of it. A mesh has no faces along most paths; without offsets the crack would follow its edges.
std::vector<std::uint8_t> sides_of_crack(const TetMesh& mesh, NodeId node, std::span<const Corners> star,
                                         const Vec3& normal, const Vec3& offset = Vec3::Zero());

/// Returns a third of the linked faces at a node between the sides, as a vector to the upper one at rest [m²].
///   above  per tet of the node's star: 1 on the upper side
Vec3 linked_area(const TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above);

/// Returns the force of an element on a corner [N]; `state`: of the whole element, also of a quadratic one.
Vec3 corner_force(const RestElement& rest, const ElementState& state, int corner);

/// Bonds at a node of an opened face.
struct HeldNode {
  double traction = 0;  ///< traction that they bear [Pa]
  double taken = 1;     ///< part of their energy that they have taken, 0..1
};

/// Advance of a crack through a node of its front. Its energy release rate follows from virtual crack closure (Rybicki
/// & Kanninen 1977) in three dimensions and all modes:
///   G = ½ t·δ,  t = R / A
///   R   force that the elements on both sides of the plane through the node with `normal` exert on each other at it
///   A   part of the crack plane that belongs to the node: a third of each face between the sides, as a vector [m²]
///   δ   opening one element behind: mean of the open faces at the node [m]
/// A crack that stands has given its bonds the energy that they have taken: the traction that they bear at δ adds to t.
/// Nodes count by the part of the energy that their bonds have taken, so those beside a node that have just opened do
/// not count as behind it. G is 0 without such faces, or if the crack is pressed together.
struct CrackAdvance {
  Vec3 normal = Vec3::UnitX();  ///< normal of its plane
  double energy_release = 0;    ///< G [J/m²]
};

/// Returns the advance with the higher energy release rate: across the plane with `normal`, or straight on along the
/// open faces at the node if these are pulled apart, not sheared, and that releases clearly more. Beside a slit in a
/// bent bar the largest tension is along the slit, and a plane across it releases nothing.
///   star    corners of the star's tets as they are now [m]
///   forces  of these tets on the node [N]
///   offset  as in sides_of_crack() [m]
///   held    per node of the mesh; empty: no bonds
CrackAdvance best_advance(const TetMesh& mesh, NodeId node, std::span<const Corners> star, std::span<const Vec3> forces,
                          const Vec3& normal, const Vec3& offset, std::span<const HeldNode> held = {});

/// Returns an estimate of best_advance()'s energy release rate across any plane that it hardly ever exceeds, in much
/// less time [J/m²]: the opening that takes most work of the forces along it, over the narrowest plane. The actual rate
/// is up to 0.6 times as large. Arguments as in best_advance().
double energy_release_bound(const TetMesh& mesh, NodeId node, std::span<const Corners> star,
                            std::span<const Vec3> forces);

}  // namespace griffith
