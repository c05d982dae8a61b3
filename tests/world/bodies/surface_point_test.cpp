#include "sim/world/bodies/surface_point.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/geometry/triangle.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Vec3 position_of(const WorldState& world, const SurfacePoint& point) {
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 3; ++i) position += point.weights[i] * world.nodes.positions[point.nodes[i]];
  return position;
}

double distance_to_all_faces(const WorldState& world, const Body& body, const Vec3& position) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const SurfaceFace& face : body.surface) {
    const std::array<NodeId, 3> nodes = face_nodes(world.mesh, face.tet, face.face);
    std::array<Vec3, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = world.nodes.positions[nodes[i]];
    const Vec3 weights = closest_on_triangle(position, corners);
    minimum = std::min(minimum, (position_of(world, {nodes, weights}) - position).norm());
  }
  return minimum;
}

TEST(SurfacePoint, IsTheClosestOfAllFaces) {
  WorldState world = build_world(struck_block(Material{}));
  const Body& body = world.bodies[BodyId(0)];
  const SurfaceSearch surface(world, body);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 position(uniform(random), uniform(random), uniform(random));
    const SurfacePoint point = surface.closest(position);
    EXPECT_GE(point.weights.minCoeff(), 0);
    EXPECT_NEAR(point.weights.sum(), 1, 1e-12);
    EXPECT_NEAR((position_of(world, point) - position).norm(), distance_to_all_faces(world, body, position), 1e-12);
  }
}

TEST(SurfacePoint, OfACornerOrACenterIsItself) {
  WorldState world = build_world(struck_block(Material{}));
  const Body& body = world.bodies[BodyId(0)];
  const SurfaceSearch surface(world, body);
  for (const SurfaceFace& face : body.surface) {
    const std::array<NodeId, 3> nodes = face_nodes(world.mesh, face.tet, face.face);
    Vec3 center = Vec3::Zero();
    for (NodeId node : nodes) {
      const Vec3& corner = world.nodes.positions[node];
      EXPECT_LT((position_of(world, surface.closest(corner)) - corner).norm(), 1e-12);
      center += corner / 3;
    }
    EXPECT_LT((position_of(world, surface.closest(center)) - center).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace griffith::testing
