#include "ui/model/gizmo_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sim/scene/body_pose.h"

namespace griffith::ui {
namespace {

ViewCamera looking(const Vec3& eye, const Vec3& target) {
  ViewCamera camera;
  camera.eye = eye;
  camera.forward = (target - eye).normalized();
  camera.right = camera.forward.cross(Vec3::UnitY()).normalized();
  camera.up = camera.right.cross(camera.forward);
  return camera;
}

class Places {
 public:
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Vec3 point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

 private:
  std::mt19937 engine_{7};
};

TEST(ViewCamera, TheRayThroughAPixelIsSeenThere) {
  const ViewCamera camera = looking(Vec3(3, 2, 4), Vec3(0, 0.5, 0));
  Places places;
  for (int i = 0; i < 100; ++i) {
    const Vec2 pixel(places.number(0, camera.width), places.number(0, camera.height));
    const ViewRay ray = camera.ray(pixel);
    EXPECT_NEAR((*camera.pixel(ray.origin + places.number(0.1, 50) * ray.direction) - pixel).norm(), 0, 1e-9);
    EXPECT_FALSE(camera.pixel(ray.origin - ray.direction));
  }
}

TEST(GizmoGeometry, APointOfTheAxisIsNearestToTheRayThroughIt) {
  const ViewCamera camera = looking(Vec3(3, 2, 4), Vec3::Zero());
  Places places;
  for (int i = 0; i < 300; ++i) {
    const Vec3 origin = places.point(0.5), axis = Vec3::Unit(i % 3);
    const double along = places.number(-0.8, 0.8);
    const std::optional<double> found = nearest_on_axis(camera.ray(*camera.pixel(origin + along * axis)), origin, axis);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, along, 1e-9);
  }
}

TEST(GizmoGeometry, NoOtherPointOfTheAxisIsNearerToTheRay) {
  const ViewCamera camera = looking(Vec3(3, 2, 4), Vec3::Zero());
  Places places;
  for (int i = 0; i < 100; ++i) {
    const Vec3 axis = Vec3::Unit(i % 3);
    const ViewRay ray = camera.ray(Vec2(places.number(200, 440), places.number(150, 330)));
    const auto distance = [&](double t) { return (t * axis - ray.origin).cross(ray.direction).norm(); };
    const double found = nearest_on_axis(ray, Vec3::Zero(), axis).value();
    EXPECT_LE(distance(found), std::min(distance(found - 1e-3), distance(found + 1e-3)));
  }
}

TEST(GizmoGeometry, AnAxisAlongTheLineOfSightIsNotMovedAlong) {
  const ViewCamera camera = looking(Vec3(0, 0, 5), Vec3::Zero());
  EXPECT_FALSE(nearest_on_axis(camera.ray(Vec2(322, 241)), Vec3::Zero(), Vec3::UnitZ()));
  EXPECT_FALSE(nearest_on_axis(camera.ray(Vec2(320, 240)), Vec3(0, 0, 20), Vec3::UnitX())) << "behind the eye";
}

TEST(GizmoGeometry, RaysMeetPlanesThatTheyDoNotGraze) {
  const ViewCamera camera = looking(Vec3(3, 2, 4), Vec3::Zero());
  Places places;
  for (int i = 0; i < 100; ++i) {
    const int axis = i % 3;
    const Vec3 origin = places.point(0.5);
    Vec3 point = origin + places.point(0.8);
    point[axis] = origin[axis];
    const std::optional<Vec3> met = meet_plane(camera.ray(*camera.pixel(point)), origin, Vec3::Unit(axis));
    ASSERT_TRUE(met);
    EXPECT_NEAR((*met - point).norm(), 0, 1e-9);
  }
  EXPECT_FALSE(meet_plane({Vec3(0, 0.01, 5), -Vec3::UnitZ()}, Vec3::Zero(), Vec3::UnitY()));
  EXPECT_FALSE(meet_plane({Vec3(0, 0, 5), Vec3::UnitZ()}, Vec3::Zero(), Vec3::UnitZ())) << "behind the eye";
}

TEST(GizmoGeometry, ARingFollowsThePointThatIsDragged) {
  Places places;
  for (const Vec3& eye : {Vec3(3, 2, 4), Vec3(-3, 2.5, 4), Vec3(2, -3, -3)})
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 20; ++i) {
        const ViewCamera camera = looking(eye, Vec3::Zero());
        const double from = places.number(-3, 3), way = places.number(-3, 3);
        const auto ray_at = [&](double angle) {
          const Vec3 arm = std::cos(angle) * Vec3::Unit((axis + 1) % 3) + std::sin(angle) * Vec3::Unit((axis + 2) % 3);
          return camera.ray(*camera.pixel(0.5 * arm));
        };
        EXPECT_NEAR(ring_turn(ray_at(from), ray_at(from + way), Vec3::Zero(), Vec3::Unit(axis), 0.5), way, 1e-9);
      }
}

TEST(GizmoGeometry, ARingSeenFromItsEdgeRollsWithTheCursor) {
  const ViewCamera camera = looking(Vec3(0, 0, 5), Vec3::Zero());
  const auto turn = [&](const Vec2& from, const Vec2& to, const Vec3& axis) {
    return ring_turn(camera.ray(from), camera.ray(to), Vec3::Zero(), axis, 0.5);
  };
  const double pixel = camera.pixel_length(Vec3::Zero());
  EXPECT_NEAR(turn({320, 240}, {330, 240}, Vec3::UnitY()), 10 * pixel / 0.5, 1e-9) << "the front goes to the right";
  EXPECT_NEAR(turn({320, 240}, {320, 250}, Vec3::UnitX()), 10 * pixel / 0.5, 1e-9) << "the front goes down";
  EXPECT_NEAR(turn({320, 240}, {320, 260}, Vec3::UnitY()), 0, 1e-12) << "along the axis";
}

TEST(GizmoGeometry, TurnedAnglesAreTheTurn) {
  Places places;
  for (int i = 0; i < 300; ++i) {
    Vec3 degrees = places.point(400);
    if (i % 5 == 0) degrees.y() = i % 2 ? 90 : -90;  // two axes fall together
    const double angle = places.number(-3, 3);
    const Vec3 axis = Vec3::Unit(i % 3), turned = turned_degrees(degrees, axis, angle);
    const Quat expected(Eigen::AngleAxisd(angle, axis) * rotation_of(degrees));
    EXPECT_LT(expected.angularDistance(rotation_of(turned)), 1e-6) << degrees.transpose();
  }
}

TEST(GizmoGeometry, ATurnAboutOneAxisChangesItsAngleAlone) {
  EXPECT_EQ(turned_degrees(Vec3::Zero(), Vec3::UnitX(), std::numbers::pi / 12), Vec3(15, 0, 0));
  EXPECT_EQ(turned_degrees(Vec3::Zero(), Vec3::UnitY(), std::numbers::pi / 3), Vec3(0, 60, 0));
  EXPECT_EQ(turned_degrees(Vec3(20, 30, 170), Vec3::UnitZ(), std::numbers::pi / 6), Vec3(20, 30, 200));
}

TEST(GizmoGeometry, StepsAreRound) {
  EXPECT_DOUBLE_EQ(round_step(0.0234), 0.02);
  EXPECT_DOUBLE_EQ(round_step(0.0199), 0.01);
  EXPECT_DOUBLE_EQ(round_step(7), 5);
  EXPECT_DOUBLE_EQ(round_step(1), 1);
}

}  // namespace
}  // namespace griffith::ui
