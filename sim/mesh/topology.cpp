#include "sim/mesh/topology.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <tuple>

#include "sim/core/sort_unique.h"

namespace griffith {
namespace {

/// Face of a tet with its nodes ascending, so that the two sides of an inner face compare equal.
struct FaceSide {
  std::array<NodeId, 3> key;
  TetId tet;
  int face;
  bool operator<(const FaceSide& other) const {
    return std::tie(key, tet, face) < std::tie(other.key, other.tet, other.face);
  }
};

std::vector<FaceSide> sorted_face_sides(const TetMesh& mesh) {
  std::vector<FaceSide> sides;
  sides.reserve(4 * mesh.tets.size());
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
    for (int face = 0; face < 4; ++face) {
      std::array<NodeId, 3> key;
      for (int i = 0; i < 3; ++i) key[i] = mesh.tets[tet][kTetFaces[face][i]];
      std::sort(key.begin(), key.end());
      sides.push_back({key, tet, face});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

void link_faces(TetMesh& mesh) {
  mesh.neighbors.resize(mesh.tets.size());
  const auto sides = sorted_face_sides(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const FaceSide &a = sides[i], &b = sides[i + 1];
    if (a.key != b.key) continue;
    assert((i + 2 == sides.size() || sides[i + 2].key != a.key) && "a face of three tets: the soup was not prepared");
    mesh.neighbors[a.tet][a.face] = b.tet;
    mesh.neighbors[b.tet][b.face] = a.tet;
  }
}

void add_stars(TetMesh& mesh) {
  mesh.stars.resize(mesh.rest_positions.size());
  for (int tet = 0; tet < mesh.tet_count(); ++tet)
    for (NodeId node : mesh.tets[tet]) mesh.stars[node].push_back(TetId(tet));
}

/// Splits `tets` (ascending) into parts connected through the links for which crosses(tet, face) holds.
template <class Crosses>
std::vector<std::vector<TetId>> components(const TetMesh& mesh, std::span<const TetId> tets, Crosses crosses) {
  std::vector<char> visited(tets.size(), 0);
  std::vector<std::vector<TetId>> result;
  std::vector<TetId> queue;
  const auto visit = [&](TetId tet) {
    const auto found = std::lower_bound(tets.begin(), tets.end(), tet);
    if (found == tets.end() || *found != tet || visited[found - tets.begin()]) return;
    visited[found - tets.begin()] = 1;
    queue.push_back(tet);
  };
  for (std::size_t seed = 0; seed < tets.size(); ++seed) {
    if (visited[seed]) continue;
    std::vector<TetId> piece;
    visit(tets[seed]);
    while (!queue.empty()) {
      const TetId tet = queue.back();
      queue.pop_back();
      piece.push_back(tet);
      for (int face = 0; face < 4; ++face)
        if (mesh.neighbors[tet][face].valid() && crosses(tet, face)) visit(mesh.neighbors[tet][face]);
    }
    std::sort(piece.begin(), piece.end());
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace

TetMesh build_mesh(const TetSoup& soup) {
  TetMesh mesh;
  mesh.rest_positions = soup.points;
  mesh.tets.reserve(soup.tets.size());
  for (const auto& [a, b, c, d] : soup.tets) mesh.tets.push_back({NodeId(a), NodeId(b), NodeId(c), NodeId(d)});
  link_faces(mesh);
  add_stars(mesh);
  return mesh;
}

AppendedRange append(TetMesh& mesh, const TetMesh& other) {
  const AppendedRange range = {NodeId(mesh.node_count()), TetId(mesh.tet_count())};
  mesh.rest_positions.insert(mesh.rest_positions.end(), other.rest_positions.begin(), other.rest_positions.end());
  for (std::array<NodeId, 4> tet : other.tets) {
    for (NodeId& node : tet) node = node.shifted(range.first_node);
    mesh.tets.push_back(tet);
  }
  for (std::array<TetId, 4> links : other.neighbors) {
    for (TetId& tet : links)
      if (tet.valid()) tet = tet.shifted(range.first_tet);
    mesh.neighbors.push_back(links);
  }
  for (std::vector<TetId> star : other.stars) {
    for (TetId& tet : star) tet = tet.shifted(range.first_tet);
    mesh.stars.push_back(std::move(star));
  }
  return range;
}

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6;
}

double rest_volume(const TetMesh& mesh, TetId tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  const auto& x = mesh.rest_positions;
  return signed_volume(x[a], x[b], x[c], x[d]);
}

Vec3 rest_centroid(const TetMesh& mesh, TetId tet) {
  Vec3 sum = Vec3::Zero();
  for (NodeId node : mesh.tets[tet]) sum += mesh.rest_positions[node];
  return sum / 4;
}

int local_corner(const TetMesh& mesh, TetId tet, NodeId node) {
  const auto& corners = mesh.tets[tet];
  const auto found = std::find(corners.begin(), corners.end(), node);
  return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

std::array<NodeId, 3> face_nodes(const TetMesh& mesh, TetId tet, int face) {
  const auto& corners = mesh.tets[tet];
  return {corners[kTetFaces[face][0]], corners[kTetFaces[face][1]], corners[kTetFaces[face][2]]};
}

Vec3 area_vector(std::span<const Vec3> positions, const std::array<NodeId, 3>& nodes) {
  const Vec3& origin = positions[nodes[0]];
  return 0.5 * (positions[nodes[1]] - origin).cross(positions[nodes[2]] - origin);
}

int face_toward(const TetMesh& mesh, TetId tet, TetId other) {
  const auto& links = mesh.neighbors[tet];
  const auto found = std::find(links.begin(), links.end(), other);
  assert(found != links.end());
  return static_cast<int>(found - links.begin());
}

std::vector<NodeId> nodes_of(const TetMesh& mesh, std::span<const TetId> tets) {
  std::vector<NodeId> nodes;
  nodes.reserve(4 * tets.size());
  for (TetId tet : tets) nodes.insert(nodes.end(), mesh.tets[tet].begin(), mesh.tets[tet].end());
  sort_unique(nodes);
  return nodes;
}

std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh, std::span<const TetId> tets) {
  std::vector<TetId> ascending(tets.begin(), tets.end());
  std::sort(ascending.begin(), ascending.end());
  return components(mesh, ascending, [](TetId, int) { return true; });
}

std::vector<std::vector<TetId>> connected_components(const TetMesh& mesh) {
  std::vector<TetId> all(mesh.tets.size());
  for (int tet = 0; tet < mesh.tet_count(); ++tet) all[tet] = TetId(tet);
  return components(mesh, all, [](TetId, int) { return true; });
}

std::vector<std::vector<TetId>> star_components(const TetMesh& mesh, NodeId node) {
  return components(mesh, mesh.stars[node], [&](TetId tet, int face) { return mesh.tets[tet][face] != node; });
}

std::vector<std::vector<TetId>> edge_components(const TetMesh& mesh, NodeId a, NodeId b) {
  std::vector<TetId> round;
  std::ranges::set_intersection(mesh.stars[a], mesh.stars[b], std::back_inserter(round));
  return components(mesh, round,
                    [&](TetId tet, int face) { return mesh.tets[tet][face] != a && mesh.tets[tet][face] != b; });
}

std::vector<SurfaceFace> surface_faces(const TetMesh& mesh) {
  std::vector<SurfaceFace> faces;
  for (int tet = 0; tet < mesh.tet_count(); ++tet)
    for (int face = 0; face < 4; ++face)
      if (!mesh.neighbors[tet][face].valid()) faces.push_back({TetId(tet), face});
  return faces;
}

}  // namespace griffith
