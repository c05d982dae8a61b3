#include "sim/fracture/split.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <unordered_set>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

struct CutFace {
  TetId tet;
  int face;
  TetId neighbor;
};

Vec3 centroid(const TetMesh& mesh, std::span<const Vec3> positions, TetId tet) {
  Vec3 sum = Vec3::Zero();
  for (NodeId corner : mesh.tets[tet]) sum += positions[corner];
  return sum / 4;
}

/// Returns the faces at the node between tets on opposite sides, without duplicates.
std::vector<CutFace> faces_across(const TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above) {
  const std::vector<TetId>& star = mesh.stars[node];
  const auto is_above = [&](TetId tet) { return above[std::ranges::lower_bound(star, tet) - star.begin()] != 0; };
  std::vector<CutFace> faces;
  for (TetId tet : star) {
    if (!is_above(tet)) continue;
    for (int face = 0; face < 4; ++face) {
      const TetId neighbor = mesh.neighbors[tet][face];
      const bool at_node = mesh.tets[tet][face] != node;
      if (at_node && neighbor.valid() && !is_above(neighbor)) faces.push_back({tet, face, neighbor});
    }
  }
  return faces;
}

void cut(TetMesh& mesh, const std::vector<CutFace>& faces) {
  for (const CutFace& cut_face : faces) {
    mesh.neighbors[cut_face.neighbor][face_toward(mesh, cut_face.neighbor, cut_face.tet)] = TetId();
    mesh.neighbors[cut_face.tet][cut_face.face] = TetId();
  }
}

/// Reverts cut(). The faces still match because no node has been copied yet.
void join(TetMesh& mesh, const std::vector<CutFace>& faces) {
  for (const CutFace& cut_face : faces) {
    mesh.neighbors[cut_face.tet][cut_face.face] = cut_face.neighbor;
    const auto& corners = mesh.tets[cut_face.neighbor];
    for (int i = 0; i < 4; ++i)
      if (local_corner(mesh, cut_face.tet, corners[i]) < 0) mesh.neighbors[cut_face.neighbor][i] = cut_face.tet;
  }
}

/// True if one of the face-connected pieces beside the faces has fewer than `count` tets.
bool leaves_small_piece(const TetMesh& mesh, const std::vector<CutFace>& faces, int count) {
  std::unordered_set<TetId> large;  // tets of pieces known to be large enough
  const auto is_small = [&](TetId start) {
    std::vector<TetId> piece = {start};
    std::unordered_set<TetId> found = {start};
    for (std::size_t next = 0; next < piece.size() && static_cast<int>(piece.size()) < count; ++next) {
      if (large.contains(piece[next])) return false;
      for (TetId neighbor : mesh.neighbors[piece[next]])
        if (neighbor.valid() && found.insert(neighbor).second) piece.push_back(neighbor);
    }
    if (static_cast<int>(piece.size()) < count) return true;
    large.merge(found);
    return false;
  };
  return std::ranges::any_of(faces, [&](const CutFace& face) { return is_small(face.tet) || is_small(face.neighbor); });
}

/// Gives every component of the node's star except the first a copy of the node.
void part_node(TetMesh& mesh, NodeId node, SplitResult& result) {
  std::vector<std::vector<TetId>> components = star_components(mesh, node);
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (std::size_t i = 1; i < components.size(); ++i) {
    const NodeId copy(mesh.node_count());
    mesh.rest_positions.push_back(Vec3(mesh.rest_positions[node]));
    for (TetId tet : components[i]) std::replace(mesh.tets[tet].begin(), mesh.tets[tet].end(), node, copy);
    mesh.stars.push_back(std::move(components[i]));
    result.copies.push_back({node, copy});
  }
  if (components.size() > 1) {
    mesh.stars[node] = std::move(components.front());
  } else {
    result.front.push_back(node);
  }
}

}  // namespace

std::vector<std::uint8_t> tets_above(const TetMesh& mesh, std::span<const Vec3> positions, NodeId node,
                                     const Vec3& normal) {
  std::vector<std::uint8_t> above;
  for (TetId tet : mesh.stars[node]) above.push_back(normal.dot(centroid(mesh, positions, tet) - positions[node]) > 0);
  return above;
}

SplitResult split_node(TetMesh& mesh, std::span<const Vec3> positions, NodeId node, const Vec3& normal,
                       int min_fragment_tets) {
  return split_node(mesh, node, tets_above(mesh, positions, node, normal), min_fragment_tets);
}

SplitResult split_node(TetMesh& mesh, NodeId node, std::span<const std::uint8_t> above, int min_fragment_tets) {
  assert(above.size() == mesh.stars[node].size());
  SplitResult result;
  const std::vector<CutFace> faces = faces_across(mesh, node, above);
  if (faces.empty()) return result;

  cut(mesh, faces);
  if (min_fragment_tets > 1 && leaves_small_piece(mesh, faces, min_fragment_tets)) {
    join(mesh, faces);
    result.too_small = true;
    return result;
  }

  std::set<NodeId> touched = {node};
  std::set<TetId> changed;
  for (const CutFace& face : faces) {
    changed.insert({face.tet, face.neighbor});
    for (int i = 0; i < 4; ++i)
      if (i != face.face) touched.insert(mesh.tets[face.tet][i]);
  }
  for (NodeId touched_node : touched) part_node(mesh, touched_node, result);
  result.changed_tets.assign(changed.begin(), changed.end());
  return result;
}

}  // namespace griffith
