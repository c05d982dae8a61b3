#include "ui/model/painted_region.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sim/geometry/triangle_hit.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/body_pose.h"

namespace griffith::ui {
namespace {

int scene_body_of(const Frame& frame, std::size_t tet) { return frame.bodies[frame.elements.bodies[tet]].scene_body; }

/// Calls `action` with the tet and the corners of each face of the surface.
template <class Action>
void for_each_surface_face(const Frame& frame, Action action) {
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    const std::array<NodeId, 4>& corners = frame.elements.tets[tet];
    for (std::size_t face = 0; face < 4; ++face) {
      if (frame.elements.neighbours[tet][face].valid()) continue;
      const std::array<int, 3>& of_face = kTetFaces[face];
      action(tet, std::array<NodeId, 3>{corners[of_face[0]], corners[of_face[1]], corners[of_face[2]]});
    }
  }
}

/// Calls `action` with each node of the scene body.
template <class Action>
void for_each_node(const Frame& frame, int scene_body, Action action) {
  for (std::size_t node = 0; node < frame.nodes.points.size(); ++node) {
    const std::vector<TetId>& star = frame.nodes.stars[node];
    if (!star.empty() && scene_body_of(frame, static_cast<std::size_t>(star.front().value)) == scene_body)
      action(NodeId(static_cast<std::int32_t>(node)));
  }
}

}  // namespace

std::set<int> nodes_in_region(const Frame& start, const Scene& scene, int scene_body, const Region& region) {
  constexpr double kTolerance = 1e-9;  // of the body's size
  const Pose pose = pose_of(scene.bodies[static_cast<std::size_t>(scene_body)]);
  Eigen::AlignedBox3d bounds;
  for_each_node(start, scene_body, [&](NodeId node) { bounds.extend(start.nodes.rest_positions[node]); });
  std::set<int> nodes;
  for_each_node(start, scene_body, [&](NodeId node) {
    const int point = start.nodes.points[node];
    if (contains(region, pose.to_local(start.nodes.rest_positions[node]), point, kTolerance * bounds.diagonal().norm()))
      nodes.insert(point);
  });
  return nodes;
}

std::optional<Vec3> place_on_body(const Frame& start, int scene_body, const ViewRay& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  bool hits_body = false;
  for_each_surface_face(start, [&](std::size_t tet, const std::array<NodeId, 3>& corners) {
    const auto place = [&](int i) { return start.nodes.positions[corners[i]]; };
    const std::optional<double> t = triangle_hit(ray.origin, ray.direction, place(0), place(1), place(2));
    if (!t || *t >= nearest) return;
    nearest = *t;
    hits_body = scene_body_of(start, tet) == scene_body;
  });
  return hits_body ? std::optional<Vec3>(ray.origin + nearest * ray.direction) : std::nullopt;
}

std::set<int> nodes_under_brush(const Frame& start, int scene_body, const Vec3& place, const Vec3& direction,
                                double radius) {
  std::set<int> nodes;
  double least = std::numeric_limits<double>::infinity();
  int nearest = -1;
  for_each_surface_face(start, [&](std::size_t tet, const std::array<NodeId, 3>& corners) {
    if (scene_body_of(start, tet) != scene_body) return;
    const auto corner = [&](int i) -> const Vec3& { return start.nodes.positions[corners[i]]; };
    if ((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(direction) >= 0) return;
    for (int i = 0; i < 3; ++i) {
      const double distance = (corner(i) - place).norm();
      const int point = start.nodes.points[corners[i]];
      if (distance <= radius) nodes.insert(point);
      if (distance < least) {
        least = distance;
        nearest = point;
      }
    }
  });
  if (nodes.empty() && nearest >= 0) nodes.insert(nearest);
  return nodes;
}

std::vector<Vec3> places_of_nodes(const Frame& start, int scene_body, const std::set<int>& nodes) {
  std::vector<Vec3> places;
  for_each_node(start, scene_body, [&](NodeId node) {
    if (nodes.contains(start.nodes.points[node])) places.push_back(start.nodes.positions[node]);
  });
  return places;
}

}  // namespace griffith::ui
