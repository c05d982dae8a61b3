#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "renderer/glyph_shapes.h"
#include "tests/renderer/renderer_fixture.h"
#include "tests/renderer/wall_scene.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

class GlyphTest : public RendererFixture {
 protected:
  static Image picture(const DrawScene& scene, int samples = 1) {
    return RendererFixture::picture(scene, options(samples));
  }
};

TEST(GlyphShapes, EnclosingShapesAreClosedAndTheirNormalsPointOutwards) {
  const auto volume = [](const std::vector<GlyphCorner>& corners) {
    float sum = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
      sum += corners[i].position.dot(corners[i + 1].position.cross(corners[i + 2].position)) / 6;
    return std::abs(sum);
  };
  EXPECT_FLOAT_EQ(volume(box_shape()), 8);
  EXPECT_NEAR(volume(ball_shape()), 4.19f, 0.15f);  // a polyhedron within the ball
  EXPECT_LT(volume(ball_shape()), 4.1888f);
  EXPECT_LT(volume(disc_shape()), 1e-6f);
  for (const GlyphCorner& corner : ball_shape()) EXPECT_LT((corner.position - corner.normal).norm(), 1e-5f);
  for (const auto& shape : {arrow_shape(), ball_shape(), disc_shape(), box_shape()}) {
    ASSERT_EQ(shape.size() % 3, 0u);
    for (const GlyphCorner& corner : shape) EXPECT_GT(corner.normal.norm(), 0.5f);
  }
}

TEST_F(GlyphTest, ABallGlyphCoversWhatASphereDoes) {
  const auto pixels = [&] {
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) count += renderer_->id_at(x, y) == 7;
    return count;
  };
  DrawScene sphere, glyph;
  sphere.spheres = {{camera().target, 0.8f, {}, 7}};
  glyph.glyphs.balls = {{camera().target, 0.8f * Eigen::Matrix3f::Identity(), {}, 1, 7}};
  picture(sphere);
  const int expected = pixels();
  picture(glyph);
  EXPECT_NEAR(pixels(), expected, 0.03 * expected);
  // Squeezed to half its height it covers about half; turning it about the line of sight changes nothing.
  glyph.glyphs.balls[0].axes.row(1) *= 0.5f;
  picture(glyph);
  EXPECT_LT(pixels(), 0.75 * expected);
}

TEST_F(GlyphTest, AnArrowEndsWhereItsAxisSays) {
  DrawScene scene;
  const Camera from = camera();
  const Vector3f forward = (from.target - from.position).normalized();
  const Vector3f right = forward.cross(Vector3f::UnitY()).normalized(), up = right.cross(forward);
  Eigen::Matrix3f axes;
  axes << 1.5f * right, 0.1f * up, 0.1f * forward;
  scene.glyphs.arrows = {{from.target, axes, {1, 0, 0}, 1, 5}};
  picture(scene);
  const auto pixel_of = [&](const Vector3f& place) {
    const Eigen::Matrix4f projection = projection_matrix(from, 1.6f, bounds(scene)) * view_matrix(from);
    const Eigen::Vector4f clip = projection * place.homogeneous();
    return static_cast<int>((0.5f + 0.5f * clip.x() / clip.w()) * kWidth);
  };
  int first = kWidth, last = 0;
  for (int x = 0; x < kWidth; ++x) {
    if (renderer_->id_at(x, kHeight / 2) != 5) continue;
    first = std::min(first, x);
    last = std::max(last, x);
  }
  EXPECT_NEAR(first, pixel_of(from.target), 1);
  EXPECT_NEAR(last, pixel_of(from.target + 1.5f * right), 2);
}

TEST_F(GlyphTest, OneTransparentLayerMixesExactly) {
  for (const int samples : {1, 4}) {
    for (const float opacity : {0.2f, 0.5f, 0.9f}) {
      DrawScene scene;
      scene.background = {{0.2f, 0.4f, 0.8f}, {0.2f, 0.4f, 0.8f}};
      scene.surface.positions = filling_square(camera(), 0);
      scene.surface.color = {0.8f, 0.5f, 0.2f};
      const auto opaque = picture(scene, samples).pixel(100, 80);
      scene.surface.opacity = opacity;
      const auto mixed = picture(scene, samples).pixel(100, 80);
      const std::array<float, 3> behind = {51, 102, 204};
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(mixed[k], opacity * static_cast<float>(opaque[k]) + (1 - opacity) * behind[k], 2) << opacity;
    }
  }
}

TEST_F(GlyphTest, TransparencyDoesNotDependOnTheOrderOfDrawing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  DrawScene scene = wall_scene();
  for (int i = 0; i < 60; ++i) {
    const Vector3f center(3 * unit(random) - 1.5f, 2.5f * unit(random), 2 * unit(random));
    scene.glyphs.discs.push_back(
        {center, 0.4f * Eigen::Matrix3f::Identity(), {unit(random), unit(random), unit(random)}, 0.5f, kNoId});
  }
  const Image one = picture(scene, 4);
  std::shuffle(scene.glyphs.discs.begin(), scene.glyphs.discs.end(), random);
  const Image other = picture(scene, 4);
  EXPECT_LT(off_fraction(one, other), 1e-3);
  scene.glyphs.discs.clear();
  EXPECT_GT(off_fraction(one, picture(scene, 4)), 0.02);
}

TEST_F(GlyphTest, WhatIsSeenThroughShowsWhatIsInsideAndCanBePicked) {
  DrawScene scene = wall_scene();
  scene.spheres.clear();
  scene.lines.clear();
  scene.glyphs.balls = {{{-0.6f, 1.0f, 0}, 0.1f * Eigen::Matrix3f::Identity(), {1, 0, 0}, 1, 2000000}};  // in the wall
  const auto red = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      count += image.rgba[i] > 130 && image.rgba[i + 1] < image.rgba[i] - 60;
    return count;
  };
  const int selected_red = red(picture(scene));
  scene.surface.opacity = 0.3f;
  EXPECT_GT(red(picture(scene)), selected_red + 20);
  int wall_pixels = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_NE(renderer_->id_at(x, y), 2000000);  // the wall is before it
      wall_pixels += renderer_->id_at(x, y) >= 0;
    }
  EXPECT_GT(wall_pixels, 3000);
}

TEST_F(GlyphTest, OnlyTheVisibleHalfOfASurfaceIsDrawn) {
  DrawScene scene = wall_scene();
  scene.spheres.clear();
  scene.lines.clear();
  picture(scene);
  std::vector<std::int32_t> whole;
  for (int x = 0; x < kWidth; ++x) whole.push_back(renderer_->id_at(x, kHeight / 2));
  for (const float sign : {-1.0f, 1.0f}) {
    scene.visible = HalfSpace{Vector3f(0, sign, 0), 0};
    picture(scene);
    for (int x = 0; x < kWidth; ++x) {
      const std::int32_t id = renderer_->id_at(x, kHeight / 2);
      EXPECT_EQ(id, sign < 0 ? whole[static_cast<std::size_t>(x)] : kNoId);  // all of the wall is above the ground
    }
  }
}

/// Count and true functions of draw calls.
int draw_calls = 0;
decltype(epoxy_glDrawArrays) true_draw_arrays;
decltype(epoxy_glDrawArraysInstanced) true_draw_instanced;

TEST_F(GlyphTest, NumberOfDrawCallsDoesNotGrowWithTheScene) {
  DrawScene arrow;
  arrow.glyphs.arrows.push_back({{0, 0, 0}, Eigen::Matrix3f::Identity(), {}, 1, 0});
  picture(arrow);  // the loader finds a function when it is first called, and would call the counter for ever
  true_draw_arrays = epoxy_glDrawArrays;
  true_draw_instanced = epoxy_glDrawArraysInstanced;
  epoxy_glDrawArrays = [](GLenum mode, GLint first, GLsizei count) {
    ++draw_calls;
    true_draw_arrays(mode, first, count);
  };
  epoxy_glDrawArraysInstanced = [](GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    ++draw_calls;
    true_draw_instanced(mode, first, count, instances);
  };
  const auto calls_for = [&](int triangles) {
    DrawScene scene;
    for (int i = 0; i < triangles; ++i) {
      const auto x = static_cast<float>(i % 500) * 0.01f, y = static_cast<float>(i / 500) * 0.01f;
      scene.surface.positions.insert(scene.surface.positions.end(), {{x, y, 0}, {x + 0.01f, y, 0}, {x, y + 0.01f, 0}});
      scene.surface.scalars.push_back(x);
      scene.surface.flags.push_back(kAllEdges);
      scene.surface.ids.push_back(i);
      if (i < 1000) scene.glyphs.arrows.push_back({{x, y, 0}, 0.01f * Eigen::Matrix3f::Identity(), {}, 1, i});
    }
    draw_calls = 0;
    picture(scene);
    return draw_calls;
  };
  const int few = calls_for(10);
  EXPECT_EQ(calls_for(200000), few);  // all faces of 50,000 tets, each by itself
  EXPECT_LE(few, 10);
  epoxy_glDrawArrays = true_draw_arrays;
  epoxy_glDrawArraysInstanced = true_draw_instanced;
}

/// The id of the triangle that a ray meets first; kNoId where none.
std::int32_t cast_ray(const Surface& surface, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  std::int32_t id = kNoId;
  for (std::size_t i = 0; i < surface.ids.size(); ++i) {
    const Eigen::Vector3d a = surface.positions[3 * i].cast<double>(), b = surface.positions[3 * i + 1].cast<double>(),
                          c = surface.positions[3 * i + 2].cast<double>();
    Eigen::Matrix3d system;
    system << b - a, c - a, -ray.direction.cast<double>();
    if (std::abs(system.determinant()) < 1e-14) continue;
    const Eigen::Vector3d found = system.inverse() * (ray.origin.cast<double>() - a);
    const bool inside = found[0] >= 0 && found[1] >= 0 && found[0] + found[1] <= 1 && found[2] > 0;
    if (inside && found[2] < nearest) nearest = found[2], id = surface.ids[i];
  }
  return id;
}

TEST_F(GlyphTest, PickingAgreesWithARayCastOnTheCpu) {
  DrawScene scene = wall_scene();
  scene.spheres.clear();
  scene.lines.clear();
  scene.points.clear();
  std::mt19937 random(11);
  for (const int samples : {1, 4}) {
    picture(scene, samples);
    constexpr int kTrials = 400;
    int hits = 0, doubtful = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const int x = static_cast<int>(random() % kWidth), y = static_cast<int>(random() % kHeight);
      const auto id_through = [&](float dx, float dy) {
        return cast_ray(scene.surface, pixel_ray(camera(), static_cast<float>(x) + 0.5f + dx,
                                                 static_cast<float>(y) + 0.5f + dy, kWidth, kHeight));
      };
      const std::int32_t id = renderer_->id_at(x, y);
      hits += id >= 0;
      if (id_through(0, 0) == id) continue;
      // An edge passes through the pixel; the device may have sampled slightly off its center.
      ++doubtful;
      const float reach = samples == 1 ? 0.02f : 0.5f;
      const std::array offsets{-reach, -0.5f * reach, 0.0f, 0.5f * reach, reach};
      const bool near = std::ranges::any_of(offsets, [&](float dx) {
        return std::ranges::any_of(offsets, [&](float dy) { return id_through(dx, dy) == id; });
      });
      EXPECT_TRUE(near) << "pixel " << x << ", " << y << ": " << id << ", not " << id_through(0, 0);
    }
    EXPECT_GT(hits, kTrials / 5);
    EXPECT_LT(doubtful, samples == 1 ? kTrials / 100 : kTrials / 5);
  }
}

}  // namespace
}  // namespace griffith::render
