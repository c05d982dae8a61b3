#include "tests/mesh/mesh_invariants.h"

#include <algorithm>
#include <map>

#include "sim/mesh/topology.h"

namespace griffith::testing {
namespace {

constexpr std::size_t kMaxFindings = 20;

class Findings {
 public:
  /// Adds "`what` `index` `problem`" unless `holds` or the list is full.
  void require(bool holds, const char* what, int index, const char* problem) {
    if (!holds && list.size() < kMaxFindings)
      list.push_back(std::string(what) + " " + std::to_string(index) + " " + problem);
  }
  std::vector<std::string> list;
};

std::array<NodeId, 3> sorted_face(const TetMesh& mesh, TetId tet, int face) {
  auto nodes = face_nodes(mesh, tet, face);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

void check_tets(const TetMesh& mesh, Findings& findings) {
  for (int tet = 0; tet < mesh.tet_count(); ++tet) {
    for (NodeId node : mesh.tets[tet])
      findings.require(node.valid() && node.index() < mesh.node_count(), "tet", tet,
                       "has a corner that does not exist");
    for (TetId other : mesh.neighbors[tet])
      findings.require(other.index() < mesh.tet_count(), "tet", tet, "has a neighbor that does not exist");
    if (findings.list.empty())
      findings.require(rest_volume(mesh, TetId(tet)) > 0, "tet", tet, "has no positive volume");
  }
}

/// Checks the links against the tets at each face, found by the face's nodes.
void check_links(const TetMesh& mesh, Findings& findings) {
  std::map<std::array<NodeId, 3>, std::vector<TetId>> tets_of_face;
  for (int tet = 0; tet < mesh.tet_count(); ++tet)
    for (int face = 0; face < 4; ++face) tets_of_face[sorted_face(mesh, TetId(tet), face)].push_back(TetId(tet));
  for (int tet = 0; tet < mesh.tet_count(); ++tet)
    for (int face = 0; face < 4; ++face) {
      const auto& sharing = tets_of_face[sorted_face(mesh, TetId(tet), face)];
      findings.require(sharing.size() <= 2, "tet", tet, "has a face shared by more than two tets");
      const TetId other = sharing.size() < 2 ? TetId() : sharing[0] == TetId(tet) ? sharing[1] : sharing[0];
      findings.require(mesh.neighbors[tet][face] == other, "tet", tet,
                       "has a link that disagrees with the shared nodes");
    }
}

void check_stars(const TetMesh& mesh, Findings& findings) {
  std::vector<std::vector<TetId>> stars(mesh.rest_positions.size());
  for (int tet = 0; tet < mesh.tet_count(); ++tet)
    for (NodeId node : mesh.tets[tet]) stars[node].push_back(TetId(tet));
  for (int node = 0; node < mesh.node_count(); ++node) {
    findings.require(!stars[node].empty(), "node", node, "belongs to no tet");
    findings.require(mesh.stars[node] == stars[node], "node", node, "has a wrong star");
    if (mesh.stars[node] != stars[node]) continue;
    findings.require(star_components(mesh, NodeId(node)).size() <= 1, "node", node,
                     "joins parts that share no face there");
  }
}

}  // namespace

std::vector<std::string> check_invariants(const TetMesh& mesh) {
  if (mesh.neighbors.size() != mesh.tets.size()) return {"neighbors and tets differ in number"};
  if (mesh.stars.size() != mesh.rest_positions.size()) return {"stars and nodes differ in number"};
  Findings findings;
  check_tets(mesh, findings);
  if (!findings.list.empty()) return findings.list;
  check_links(mesh, findings);
  check_stars(mesh, findings);
  return findings.list;
}

}  // namespace griffith::testing
