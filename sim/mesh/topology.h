#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// The mesh of a soup in which every tet is positively oriented, every point is used and no face has more than two tets
/// (see prepare() in mesh_report.h). Neighbours come from sorting the faces: O(n log n), the same for the same soup.
TetMesh build_mesh(const TetSoup& soup);

/// Where an appended soup went: its node i became node first_node + i, its tet i tet first_tet + i.
struct AppendedRange {
  NodeId first_node;
  TetId first_tet;
};

/// Adds a mesh to another; nothing links the two.
AppendedRange append(TetMesh& mesh, const TetMesh& other);

/// The signed volume of a tet [m³], det(b−a, c−a, d−a) / 6.
double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// The volume of a tet in rest space [m³].
double rest_volume(const TetMesh& mesh, TetId tet);
/// The middle of a tet in rest space [m].
Vec3 rest_centroid(const TetMesh& mesh, TetId tet);

/// Which corner (0..3) of `tet` is `node`; -1 when none is.
int local_corner(const TetMesh& mesh, TetId tet, NodeId node);
/// The nodes of face i of a tet, counter-clockwise seen from outside.
std::array<NodeId, 3> face_nodes(const TetMesh& mesh, TetId tet, int face);

/// Which face (0..3) of `tet` leads to its neighbour `other`; they must be linked.
int face_towards(const TetMesh& mesh, TetId tet, TetId other);

/// The nodes of `tets`, ascending, each once.
std::vector<NodeId> nodes_of(const TetMesh& mesh, std::span<const TetId> tets);

/// The pieces into which `tets` (any order, no repetition) fall when they hold together through common faces only. Each
/// piece is ascending, and the pieces are ordered by their first tets.
std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh, std::span<const TetId> tets);
/// The pieces of the whole mesh.
std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh);
/// The pieces of a node's star that hold together through faces containing the node. More than one: the node is
/// pinched.
std::vector<std::vector<TetId>> star_components(const TetMesh& mesh, NodeId node);

/// The tets round edge ab, in the pieces that hold together through faces containing the edge. More than one: the edge
/// is pinched; none: a and b share no tet.
std::vector<std::vector<TetId>> edge_components(const TetMesh& mesh, NodeId a, NodeId b);

/// Face `face` of `tet`, with nothing behind it.
struct SurfaceFace {
  TetId tet;
  int face = 0;
};

/// All faces without a neighbour, by tet, then face.
std::vector<SurfaceFace> surface_faces(const TetMesh& mesh);

/// What is wrong with a mesh, a sentence each, for tests: ids in range, volumes positive, links symmetric and across
/// the same three nodes, equal faces linked, stars exact and ascending, no node without tets, every star held together
/// by faces. Empty when all is well; stops after 20 findings.
std::vector<std::string> check_invariants(const TetMesh& mesh);

}  // namespace griffith
