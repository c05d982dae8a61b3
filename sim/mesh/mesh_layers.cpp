#include "sim/mesh/mesh_layers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

/// Least number of edges from each node to the surface.
std::vector<int> depths_of_nodes(const TetMesh& mesh) {
  std::vector<int> depths(mesh.node_count(), -1);
  std::vector<NodeId> front;
  const auto reach = [&](NodeId node, int depth, std::vector<NodeId>& reached) {
    if (depths[node] >= 0) return;
    depths[node] = depth;
    reached.push_back(node);
  };
  for (const SurfaceFace& face : surface_faces(mesh))
    for (const NodeId node : face_nodes(mesh, face.tet, face.face)) reach(node, 0, front);
  for (int depth = 1; !front.empty(); ++depth) {
    std::vector<NodeId> next;
    for (const NodeId node : front)
      for (const TetId tet : mesh.stars[node])
        for (const NodeId other : mesh.tets[tet]) reach(other, depth, next);
    front = std::move(next);
  }
  return depths;
}

/// Layers of each tet by its own corners: twice the depth of the deepest, and one more if all are as deep.
std::vector<int> own_layers(const TetMesh& mesh, const std::vector<int>& depths) {
  std::vector<int> layers;
  for (const std::array<NodeId, 4>& corners : mesh.tets) {
    const auto [least, most] =
        std::minmax({depths[corners[0]], depths[corners[1]], depths[corners[2]], depths[corners[3]]});
    layers.push_back(2 * most + (least == most));
  }
  return layers;
}

/// The most layers of the tets of each node, and of those that paths to deeper nodes lead to.
std::vector<int> layers_inward(const TetMesh& mesh, const std::vector<int>& depths, const std::vector<int>& layers) {
  std::vector<NodeId> deepest_first;
  for (const NodeId node : IdRange<NodeId>(0, mesh.node_count())) deepest_first.push_back(node);
  std::ranges::stable_sort(deepest_first, std::greater(), [&](NodeId node) { return depths[node]; });
  std::vector<int> most(mesh.node_count(), 0);
  for (const NodeId node : deepest_first)
    for (const TetId tet : mesh.stars[node]) {
      most[node] = std::max(most[node], layers[tet]);
      for (const NodeId other : mesh.tets[tet])
        if (depths[other] > depths[node]) most[node] = std::max(most[node], most[other]);
    }
  return most;
}

/// The most layers of the nodes that share a tet with each.
std::vector<int> of_neighbors(const TetMesh& mesh, const std::vector<int>& layers) {
  std::vector<int> most = layers;
  for (const std::array<NodeId, 4>& corners : mesh.tets)
    for (const NodeId node : corners)
      for (const NodeId other : corners) most[node] = std::max(most[node], layers[other]);
  return most;
}

}  // namespace

int layers_across(const TetMesh& mesh) {
  constexpr double kThinnest = 0.1;  // of the volume
  const std::vector<int> depths = depths_of_nodes(mesh);
  const std::vector<int> inward = of_neighbors(mesh, layers_inward(mesh, depths, own_layers(mesh, depths)));
  std::vector<double> volumes(1);  // by layers
  double volume = 0;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) {
    std::size_t layers = 0;
    for (const NodeId node : mesh.tets[tet]) layers = std::max<std::size_t>(layers, inward[node]);
    if (layers >= volumes.size()) volumes.resize(layers + 1);
    volumes[layers] += rest_volume(mesh, tet);
    volume += rest_volume(mesh, tet);
  }
  double thin = 0;
  for (std::size_t layers = 0; layers < volumes.size(); ++layers)
    if ((thin += volumes[layers]) > kThinnest * volume) return static_cast<int>(layers);
  return 0;
}

double slenderness(const TetMesh& mesh) {
  if (mesh.tet_count() == 0) return 0;
  double volume = 0, area = 0;
  Eigen::AlignedBox3d box;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) {
    volume += rest_volume(mesh, tet);
    for (const NodeId node : mesh.tets[tet]) box.extend(mesh.rest_positions[node]);
  }
  for (const SurfaceFace& face : surface_faces(mesh))
    area += area_vector(mesh.rest_positions, face_nodes(mesh, face.tet, face.face)).norm();
  return box.sizes().maxCoeff() * area / (2 * volume);
}

}  // namespace griffith
