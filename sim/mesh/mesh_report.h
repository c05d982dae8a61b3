#pragma once

#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Tets of lower quality (see tet_quality) count as slivers.
inline constexpr double kSliverQuality = 0.05;

/// Findings and changes of prepare().
struct MeshReport {
  int nodes = 0, tets = 0;    ///< counts after the repairs
  int reoriented_tets = 0;    ///< tets with corners in the wrong order; repaired
  int removed_tets = 0;       ///< tets with the same four corners as an earlier tet; removed
  int removed_nodes = 0;      ///< nodes of no tet; removed
  int coincident_nodes = 0;   ///< nodes exactly on an earlier node: a slit, or parts that were never joined; kept
  int overlapping_faces = 0;  ///< faces with both tets on the same side; kept
  int pinched_nodes = 0;      ///< nodes joining parts that share no face there; parted
  int pinched_edges = 0;      ///< edges joining parts that share no face there, but do at the ends; kept
  int slivers = 0;            ///< flat or stretched tets, which make the solver slow and stresses wrong; kept
  int pieces = 0;             ///< parts connected through faces
  double worst_quality = 1;   ///< smallest tet_quality
  double volume = 0;          ///< [m³]
  Vec3 minimum = Vec3::Zero(), maximum = Vec3::Zero();  ///< bounding box [m]
  Vec3 first_pinched = Vec3::Zero();                    ///< position of the first parted node [m]
  std::vector<int> point_of_node;                       ///< per node: its index among the points read
  std::vector<int> tet_of_element;                      ///< per tet read: its present index, -1 if removed
};

/// Returns the quality of a tet, 6√2·V / l_rms³ with the root mean square l_rms of its edges: 1 for a regular tet, 0
/// for a flat one, negative for an inverted one (Parthasarathy, Graichen and Hathaway 1994).
double tet_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Prepares a soup for build_mesh(). Makes the repairs that are safe and counts other findings. Parts that meet only in
/// a node or an edge get separate nodes there. `name` (a file) begins the messages. Throws InputError, naming the tet,
/// node or face (numbered from 0), if there are no tets, a corner index is out of range or repeated, a used coordinate
/// is not finite, a tet is flat (volume below 1e-12 of its longest edge cubed), or more than two tets share a face.
/// `mesh`, if given, receives build_mesh() of the soup.
MeshReport prepare(TetSoup& soup, const std::string& name = "mesh", TetMesh* mesh = nullptr);

/// Returns one sentence per finding; empty if there are none.
std::vector<std::string> findings(const MeshReport& report);

}  // namespace griffith
