#include "sim/world/bodies/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/geometry/triangle.h"

namespace griffith {
namespace {

std::array<NodeId, 3> nodes_of(const WorldState& world, const SurfaceFace& face) {
  return face_nodes(world.mesh, face.tet, face.face);
}

std::array<Vec3, 3> corners_of(const WorldState& world, const std::array<NodeId, 3>& nodes) {
  return {world.nodes.positions[nodes[0]], world.nodes.positions[nodes[1]], world.nodes.positions[nodes[2]]};
}

}  // namespace

SurfaceSearch::SurfaceSearch(const WorldState& world, const Body& body)
    : world_(world), body_(body), centers_(3, body.surface.size()), radii_(body.surface.size()) {
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    const std::array<Vec3, 3> corners = corners_of(world, nodes_of(world, body.surface[i]));
    centers_.col(i) = (corners[0] + corners[1] + corners[2]) / 3;
    radii_[i] = 0;
    for (const Vec3& corner : corners) radii_[i] = std::max(radii_[i], (corner - centers_.col(i)).norm());
  }
}

SurfacePoint SurfaceSearch::closest(const Vec3& position) const {
  const Eigen::VectorXd distances = (centers_.colwise() - position).colwise().norm();
  double bound = distances.minCoeff();  // a face's center is one of its points
  double best_distance = std::numeric_limits<double>::infinity();
  SurfacePoint best;
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    if (distances[i] - radii_[i] > bound) continue;
    const std::array<NodeId, 3> nodes = nodes_of(world_, body_.surface[i]);
    const std::array<Vec3, 3> corners = corners_of(world_, nodes);
    const Vec3 weights = closest_on_triangle(position, corners);
    const double distance =
        (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - position).norm();
    if (distance >= best_distance) continue;
    best_distance = distance;
    bound = std::min(bound, distance);
    best = {nodes, weights};
  }
  return best;
}

}  // namespace griffith
