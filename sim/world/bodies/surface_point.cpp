#include "sim/world/bodies/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith {
namespace {

/// Barycentric weights of the point of segment ab closest to p, written to entries i and j.
Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b, int i, int j) {
  const Vec3 edge = b - a;
  const double t = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  Vec3 weights = Vec3::Zero();
  weights[i] = 1 - t;
  weights[j] = t;
  return weights;
}

std::array<NodeId, 3> nodes_of(const WorldState& world, const SurfaceFace& face) {
  return face_nodes(world.mesh, face.tet, face.face);
}

std::array<Vec3, 3> corners_of(const WorldState& world, const std::array<NodeId, 3>& nodes) {
  return {world.nodes.positions[nodes[0]], world.nodes.positions[nodes[1]], world.nodes.positions[nodes[2]]};
}

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  Vec3 weights((c - b).cross(p - b).dot(normal), (a - c).cross(p - c).dot(normal), (b - a).cross(p - a).dot(normal));
  weights /= area;
  if (weights.minCoeff() >= 0) return weights;
  Vec3 best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3 candidate = closest_on_edge(p, corners[i], corners[j], i, j);
    const double distance = (candidate[i] * corners[i] + candidate[j] * corners[j] - p).squaredNorm();
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

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
  double bound = distances.minCoeff();  // a face's centre is one of its points
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
