#pragma once

#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// A tet of lower quality (see tet_quality) counts as a sliver.
inline constexpr double kSliverQuality = 0.05;

/// What prepare() found and what it changed.
struct MeshReport {
  int nodes = 0, tets = 0;    ///< after the repairs
  int reoriented_tets = 0;    ///< had their corners in the wrong order; repaired
  int removed_tets = 0;       ///< had the same four corners as an earlier tet; removed
  int removed_nodes = 0;      ///< belonged to no tet; removed
  int coincident_nodes = 0;   ///< lie exactly on an earlier node: a slit, or parts that were never joined; kept
  int overlapping_faces = 0;  ///< have both their tets on the same side; kept
  int pinched_nodes = 0;      ///< joined parts that share no face at the node; parted
  int pinched_edges = 0;      ///< join parts that share no face at the edge, but do at its ends; kept
  int slivers = 0;            ///< flat or drawn-out tets that make the solver slow and stresses wrong; kept
  int pieces = 0;             ///< parts that hold together through faces
  double worst_quality = 1;   ///< the smallest tet_quality
  double volume = 0;          ///< [m³]
  Vec3 minimum = Vec3::Zero(), maximum = Vec3::Zero();  ///< bounding box [m]
  Vec3 first_pinched = Vec3::Zero();                    ///< place of the first node that was parted [m]
  std::vector<int> point_of_node;                       ///< per node: the point as read that it was
  std::vector<int> tet_of_element;                      ///< per tet as read: its number now, -1 where it was removed
};

/// The shape of a tet, 6√2·V / l_rms³ with l_rms the root mean square of its edges: 1 for a regular tet, 0 for a flat
/// one, negative for an inverted one (Parthasarathy, Graichen and Hathaway 1994).
double tet_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Makes a soup fit for build_mesh(): repairs what has one safe repair, and counts what the user should know. Parts
/// that meet in a node or an edge alone get nodes of their own there, as when a crack leaves no more of what held them.
/// `name` (a file) begins the messages. Throws InputError, naming the tet, node or face (numbered from 0), when there
/// are no tets, a corner index is out of range or repeated, a used coordinate is not finite, a tet is flat (volume
/// below 1e-12 of its longest edge cubed), or more than two tets share a face. `mesh`, if given, receives build_mesh()
/// of the soup.
MeshReport prepare(TetSoup& soup, const std::string& name = "mesh", TetMesh* mesh = nullptr);

/// One sentence a finding, for people; empty when there is nothing to tell.
std::vector<std::string> findings(const MeshReport& report);

}  // namespace griffith
