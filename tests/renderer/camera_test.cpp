#include "renderer/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace griffith::render {
namespace {

using Eigen::Vector3f;

/// Seeded places, cameras and angles.
class CameraLaws : public testing::Test {
 protected:
  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  Vector3f place(float reach) { return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}; }

  Camera camera() {
    Camera camera;
    camera.target = place(5);
    camera.position = camera.target + place(10) + Vector3f(0, 0, 15);
    camera.vertical_fov = uniform(20, 90);
    return camera;
  }

  std::mt19937 random_{20};
};

/// The pixel, from the top left, at which a place appears.
Eigen::Vector2f project(const Camera& camera, const Vector3f& place, int width, int height) {
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const Eigen::Vector4f clip =
      projection_matrix(camera, aspect, Eigen::AlignedBox3f(place)) * view_matrix(camera) * place.homogeneous();
  const Eigen::Vector2f ndc = clip.head<2>() / clip.w();
  return {(0.5f + 0.5f * ndc.x()) * static_cast<float>(width), (0.5f - 0.5f * ndc.y()) * static_cast<float>(height)};
}

TEST_F(CameraLaws, RayThroughAProjectedPlacePassesThePlace) {
  for (int trial = 0; trial < 200; ++trial) {
    const Camera from = camera();
    const Vector3f seen = from.target + place(2);
    const Eigen::Vector2f pixel = project(from, seen, 640, 480);
    const Ray ray = pixel_ray(from, pixel.x(), pixel.y(), 640, 480);
    const Vector3f offset = seen - ray.origin;
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-5);
    EXPECT_GT(offset.dot(ray.direction), 0);
    EXPECT_LT(ray.direction.cross(offset).norm(), 1e-3f * offset.norm());
  }
}

TEST_F(CameraLaws, OrbitKeepsDistanceAndTarget) {
  for (int trial = 0; trial < 200; ++trial) {
    const Camera from = camera();
    const Camera turned = orbit(from, uniform(-7, 7), uniform(-4, 4));
    const float distance = (from.position - from.target).norm();
    EXPECT_NEAR((turned.position - turned.target).norm(), distance, 1e-4 * distance);
    EXPECT_EQ(turned.target, from.target);
    EXPECT_TRUE(view_matrix(turned).allFinite());
  }
}

TEST_F(CameraLaws, OrbitThereAndBackChangesNothing) {
  for (int trial = 0; trial < 100; ++trial) {
    const Camera from = camera();
    const float yaw = uniform(-3, 3), pitch = uniform(-0.2f, 0.2f);
    const Camera back = orbit(orbit(from, yaw, pitch), -yaw, -pitch);
    EXPECT_LT((back.position - from.position).norm(), 1e-4f * (from.position - from.target).norm());
  }
}

TEST_F(CameraLaws, OrbitWithPositiveYawMovesToTheRight) {
  const Camera from = camera();
  const Vector3f right = view_matrix(from).topLeftCorner<3, 3>().row(0);
  EXPECT_GT(right.dot(orbit(from, 0.1f, 0).position - from.position), 0);
}

TEST_F(CameraLaws, PanOfOneMovesThePictureByItsHeight) {
  for (int trial = 0; trial < 50; ++trial) {
    const Camera from = camera();
    const Eigen::Vector2f shifted = project(pan(from, 0.25f, 0.5f), from.target, 640, 480);
    EXPECT_NEAR(shifted.x(), 320 - 0.25 * 480, 0.05);
    EXPECT_NEAR(shifted.y(), 240 + 0.5 * 480, 0.05);
  }
}

TEST_F(CameraLaws, ThePictureIsAsHighAsItShowsAtTheTarget) {
  for (int i = 0; i < 100; ++i) {
    const Camera from = camera();
    const Ray top = pixel_ray(from, 50, 0, 100, 100), bottom = pixel_ray(from, 50, 100, 100, 100);
    const Vector3f forward = (from.target - from.position).normalized();
    const float distance = (from.target - from.position).norm();
    const auto at_target = [&](const Ray& ray) -> Vector3f {
      return ray.origin + distance / forward.dot(ray.direction) * ray.direction;
    };
    EXPECT_NEAR((at_target(top) - at_target(bottom)).norm(), height_at_target(from), 1e-4f * distance);
  }
}

TEST_F(CameraLaws, AWidenedPictureShowsAsMuchAcross) {
  for (int i = 0; i < 100; ++i) {
    Camera from = camera();
    from.vertical_fov = uniform(20, 50);
    const float aspect = uniform(0.7f, 3);
    const float across = std::max(16.0f / 9, aspect) * height_at_target(from);
    EXPECT_NEAR(aspect * height_at_target(widen(from, aspect)), across, 1e-4f * across);
    EXPECT_LE(widen(from, 0.01f).vertical_fov, 120.001f);
  }
}

TEST_F(CameraLaws, APictureThatContainsAnotherShowsAsMuchAcrossAndUp) {
  for (int i = 0; i < 100; ++i) {
    Camera from = camera();
    from.vertical_fov = uniform(20, 50);
    const float shown = uniform(0.7f, 3), aspect = uniform(0.7f, 3), height = height_at_target(from);
    const float now = height_at_target(contain(from, shown, aspect));
    EXPECT_NEAR(now, height * std::max(1.0f, shown / aspect), 1e-4f * now) << "no more than is needed";
    EXPECT_GE(aspect * now, (1 - 1e-4f) * shown * height);
  }
}

TEST_F(CameraLaws, ZoomScalesTheDistance) {
  const Camera from = camera();
  const Camera closer = zoom(from, 0.5f);
  EXPECT_NEAR((closer.position - closer.target).norm(), 0.5f * (from.position - from.target).norm(), 1e-4);
}

TEST_F(CameraLaws, FramedBoundsAreInThePictureAndBetweenNearAndFar) {
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::AlignedBox3f box(place(20));
    box.extend(place(20));
    const float aspect = uniform(0.4f, 2.5f);
    const Camera framed = frame_bounds(camera(), box, aspect);
    const Eigen::Matrix4f matrix = projection_matrix(framed, aspect, box) * view_matrix(framed);
    for (int k = 0; k < 8; ++k) {
      const auto corner = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(k));
      const Eigen::Vector4f clip = matrix * corner.homogeneous();
      EXPECT_LE((clip.head<3>() / clip.w()).cwiseAbs().maxCoeff(), 1) << "corner " << k << " of trial " << trial;
    }
  }
}

TEST_F(CameraLaws, ABoxIsShownIfAllItsCornersArePixels) {
  constexpr int kWidth = 640, kHeight = 360;
  constexpr float kAspect = 640.0f / 360;
  const Eigen::AlignedBox2f picture(Eigen::Vector2f(0, 0), Eigen::Vector2f(kWidth, kHeight));
  int shown = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Camera seen = camera();
    const Vector3f center = place(20), reach = place(3).cwiseAbs();
    const Eigen::AlignedBox3f box(center - reach, center + reach);
    bool is_shown = true;
    for (int k = 0; k < 8; ++k) {
      const Vector3f corner = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(k));
      is_shown = is_shown && (corner - seen.position).dot(seen.target - seen.position) > 0 &&
                 picture.contains(project(seen, corner, kWidth, kHeight));
    }
    EXPECT_EQ(shows(seen, box, kAspect), is_shown) << trial;
    EXPECT_TRUE(shows(frame_bounds(seen, box, kAspect), box, kAspect)) << trial;
    shown += is_shown;
    const Camera inside{center, center + Vector3f::UnitX()};
    EXPECT_FALSE(shows(inside, box, kAspect)) << trial;
  }
  EXPECT_GT(shown, 50);
  EXPECT_LT(shown, 450);
}

TEST(Camera, LooksStraightDown) {
  const Camera down{{1, 5, 2}, {1, 0, 2}, 40};
  const Eigen::Matrix3f rotation = view_matrix(down).topLeftCorner<3, 3>();
  EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-5f));
  EXPECT_GT((rotation * Vector3f(0, 0, -1)).y(), 0.99f);  // -Z is up in the picture
}

TEST_F(CameraLaws, AFarCameraShowsTheSameHeightByNearlyParallelRays) {
  for (int trial = 0; trial < 200; ++trial) {
    const Camera from = camera();
    const Vector3f toward = place(1).normalized();
    const Camera far = far_camera(from, toward);
    const float height = height_at_target(from);
    EXPECT_EQ(far.target, from.target);
    EXPECT_NEAR(height_at_target(far), height, 1e-3f * height);
    EXPECT_TRUE((far.position - far.target).normalized().isApprox(toward, 1e-4f));
    EXPECT_LT(pixel_ray(far, 0, 0, 640, 480).direction.cross(pixel_ray(far, 640, 480, 640, 480).direction).norm(),
              0.06f);
  }
}

}  // namespace
}  // namespace griffith::render
