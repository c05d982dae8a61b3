#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Returns the mesh of a soup in which every tet is positively oriented, every point is used and no face has more than
/// two tets (see prepare() in mesh_report.h). Neighbors are found by sorting the faces: O(n log n), deterministic.
TetMesh build_mesh(const TetSoup& soup);

/// Place of an appended soup: its node i is node first_node + i, its tet i is tet first_tet + i.
struct AppendedRange {
  NodeId first_node;
  TetId first_tet;
};

/// Appends a mesh to another without links between the two.
AppendedRange append(TetMesh& mesh, const TetMesh& other);

/// Returns the signed volume of a tet [m³], det(b−a, c−a, d−a) / 6.
double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Returns the volume of a tet in rest space [m³].
double rest_volume(const TetMesh& mesh, TetId tet);
/// Returns the centroid of a tet in rest space [m].
Vec3 rest_centroid(const TetMesh& mesh, TetId tet);

/// Returns the corner (0..3) of `tet` that is `node`; -1 if none is.
int local_corner(const TetMesh& mesh, TetId tet, NodeId node);
/// Returns the nodes of face i of a tet, counterclockwise seen from outside.
std::array<NodeId, 3> face_nodes(const TetMesh& mesh, TetId tet, int face);

/// Returns the area vector of a face with its nodes at `positions` (per node of the mesh [m]): half the cross product
/// of two edges, outward with the nodes as face_nodes() [m²].
Vec3 area_vector(std::span<const Vec3> positions, const std::array<NodeId, 3>& nodes);

/// Returns the face (0..3) of `tet` toward its neighbor `other`; they must be linked.
int face_toward(const TetMesh& mesh, TetId tet, TetId other);

/// Returns the nodes of `tets`, ascending, without duplicates.
std::vector<NodeId> nodes_of(const TetMesh& mesh, std::span<const TetId> tets);

/// Returns the pieces of `tets` (any order, no repetition) that are connected through common faces. Each piece is
/// ascending, and the pieces are in the order of their first tets.
std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh, std::span<const TetId> tets);
/// Returns the pieces of the whole mesh.
std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh);
/// Returns the pieces of a node's star that are connected through faces containing the node. The node is pinched if
/// there is more than one.
std::vector<std::vector<TetId>> star_components(const TetMesh& mesh, NodeId node);

/// Returns the tets around edge ab, as pieces connected through faces containing the edge. The edge is pinched if there
/// is more than one; a and b share no tet if there is none.
std::vector<std::vector<TetId>> edge_components(const TetMesh& mesh, NodeId a, NodeId b);

/// Face `face` of `tet`, without a neighbor.
struct SurfaceFace {
  TetId tet;
  int face = 0;
};

/// Returns all faces without a neighbor, by tet, then face.
std::vector<SurfaceFace> surface_faces(const TetMesh& mesh);

}  // namespace griffith
