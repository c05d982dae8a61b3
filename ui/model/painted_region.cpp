#include "ui/model/painted_region.h"

#include <array>
#include <limits>

#include "sim/scene/body_pose.h"
#include "sim/scene/region.h"
#include "ui/model/surface_hit.h"

namespace griffith::ui {
namespace {

int scene_body_of(const Frame& frame, std::size_t tet) { return frame.bodies[frame.elements.bodies[tet]].scene_body; }

/// Calls `action` with each node of the scene body.
template <class Action>
void for_each_node(const Frame& frame, int scene_body, Action action) {
  for (std::size_t node = 0; node < frame.nodes.points.size(); ++node) {
    const std::vector<TetId>& star = frame.nodes.stars[node];
    if (!star.empty() && scene_body_of(frame, static_cast<std::size_t>(star.front().index())) == scene_body)
      action(NodeId(static_cast<std::int32_t>(node)));
  }
}

}  // namespace

std::set<int> nodes_in_region(const Frame& start, const Scene& scene, int scene_body, const Region& region) {
  const Pose pose = pose_of(scene.bodies[static_cast<std::size_t>(scene_body)]);
  std::vector<Vec3> places;
  std::vector<int> numbers;
  for_each_node(start, scene_body, [&](NodeId node) {
    places.push_back(pose.to_local(start.nodes.rest_positions[node]));
    numbers.push_back(start.nodes.points[node]);
  });
  const std::vector<std::uint8_t> inside = nodes_in(region, places, numbers);
  std::set<int> nodes;
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (inside[i]) nodes.insert(numbers[i]);
  return nodes;
}

std::optional<Vec3> place_on_body(const Frame& start, int scene_body, const ViewRay& ray) {
  const std::optional<SurfaceHit> hit = first_surface_hit(start, ray.origin, ray.direction);
  if (!hit || scene_body_of(start, hit->tet) != scene_body) return std::nullopt;
  return ray.origin + hit->distance * ray.direction;
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
  if (nodes.empty()) return places;
  for_each_node(start, scene_body, [&](NodeId node) {
    if (nodes.contains(start.nodes.points[node])) places.push_back(start.nodes.positions[node]);
  });
  return places;
}

}  // namespace griffith::ui
