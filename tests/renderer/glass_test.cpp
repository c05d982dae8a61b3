#include <cmath>

#include "tests/renderer/renderer_fixture.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr std::int32_t kFront = 3, kBack = 4, kBehind = 9;

class GlassTest : public RendererFixture {
 protected:
  static RenderOptions clear_options(int samples = 1) {
    RenderOptions how = options(samples);
    how.quality = Quality::standard;
    how.edges = false;
    return how;
  }
};

/// A sheet of clear matter that thick [m] across the line of sight, and a gray square behind it.
DrawScene sheet(const Camera& camera, const Rgb& color, float thickness) {
  DrawScene scene;
  const auto add = [&](std::vector<Vector3f> corners, std::int32_t id, bool clear, bool turned) {
    if (turned) std::swap(corners[1], corners[2]), std::swap(corners[4], corners[5]);
    for (const Vector3f& corner : corners) scene.surface.positions.push_back(corner);
    for (int i = 0; i < 2; ++i) {
      scene.surface.ids.push_back(id);
      scene.surface.flags.push_back(clear ? kClear : 0);
      scene.surface.colors.push_back(clear ? color : Rgb{0.6f, 0.6f, 0.6f});
    }
  };
  add(filling_square(camera, -0.5f), kBehind, false, false);
  add(filling_square(camera, 0.5f), kFront, true, false);
  add(filling_square(camera, 0.5f - thickness), kBack, true, true);
  scene.surface.clear_depth = 0.1f;
  scene.environment.strength = 0;  // nothing to mirror
  return scene;
}

/// Light of a channel of a color in the sRGB encoding, above its linear part.
double encoded_light(double value) { return std::pow((value + 0.055) / 1.055, 2.4); }

/// Light that comes through the middle, by channel.
std::array<double, 3> middle(const Image& image) {
  const auto pixel = image.pixel(image.width / 2, image.height / 2);
  return {light_shown_as(pixel[0]), light_shown_as(pixel[1]), light_shown_as(pixel[2])};
}

TEST_F(GlassTest, AbsorptionGrowsWithThicknessAsBeerAndLambertSay) {
  const Rgb color = {0.55f, 0.8f, 0.7f};
  const auto through = [&](float thickness) {
    return middle(picture(sheet(camera(), color, thickness), clear_options()));
  };
  const auto thin = through(1e-3f);
  for (const float thickness : {0.05f, 0.1f, 0.2f}) {
    const auto seen = through(thickness);
    const double channels[] = {color.r, color.g, color.b};
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = std::pow(encoded_light(channels[i]), (thickness - 1e-3) / 0.1);
      EXPECT_NEAR(seen[i] / thin[i], expected, 0.02) << thickness << ", channel " << i;
    }
  }
}

/// The sheet without the triangles that are called so.
DrawScene without(DrawScene scene, std::int32_t id) {
  Surface kept = scene.surface;
  kept.positions.clear(), kept.ids.clear(), kept.flags.clear(), kept.colors.clear();
  for (std::size_t i = 0; i < scene.surface.ids.size(); ++i) {
    if (scene.surface.ids[i] == id) continue;
    for (std::size_t k = 0; k < 3; ++k) kept.positions.push_back(scene.surface.positions[3 * i + k]);
    kept.ids.push_back(scene.surface.ids[i]);
    kept.flags.push_back(scene.surface.flags[i]);
    kept.colors.push_back(scene.surface.colors[i]);
  }
  scene.surface = std::move(kept);
  return scene;
}

/// But for the 16 bits of its distance.
TEST_F(GlassTest, AFaceWithoutItsOppositeAbsorbsNothing) {
  const DrawScene whole = sheet(camera(), {0.55f, 0.8f, 0.7f}, 0.1f);
  const auto unshaded = [](int samples) {
    RenderOptions how = clear_options(samples);
    how.shadows = false;
    return how;
  };
  for (const int samples : {1, 4}) {
    const auto bare = middle(picture(without(without(whole, kFront), kBack), unshaded(samples)));
    for (const std::int32_t missing : {kFront, kBack}) {
      const auto seen = middle(picture(without(whole, missing), unshaded(samples)));
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(seen[i] / bare[i], 0.96, 0.04) << missing << ", " << samples;
    }
  }
}

/// The sheet with its back as far before the square behind it [m]; that is 1 m behind its front.
DrawScene sheet_before_square(const Camera& camera, float gap) { return sheet(camera, {0.55f, 0.8f, 0.7f}, 1 - gap); }

RenderOptions without_shadows(RenderOptions how) {
  how.shadows = false;
  return how;
}

/// Which of two faces in one place is before the other is chance, from pixel to pixel.
TEST_F(GlassTest, HasNoHolesWhereItLiesOnSomething) {
  for (const int samples : {1, 4}) {
    const RenderOptions how = without_shadows(clear_options(samples));
    const Image close = picture(sheet_before_square(camera(), 1e-3f), how);
    for (const float gap : {1e-6f, 0.0f, -1e-6f, -0.2f}) {
      const Image there = picture(sheet_before_square(camera(), gap), how);
      EXPECT_EQ(off_fraction(there, close), 0) << gap << " m, " << samples << " samples";
      EXPECT_EQ(renderer_->id_at(kWidth / 2, kHeight / 2), kFront);
    }
  }
}

constexpr int kRim = 2;  // pixels

/// True if all pixels around one that is not near the picture's edge have, or do not have, an id.
bool all_around(const IdImage& ids, int x, int y, std::int32_t id, bool is) {
  for (int row = y - kRim; row <= y + kRim; ++row)
    for (int column = x - kRim; column <= x + kRim; ++column)
      if ((ids.ids[static_cast<std::size_t>(row * ids.width + column)] == id) != is) return false;
  return true;
}

/// A slab on the ground, seen aslant, its lower face within the rounding of the ground.
TEST_F(GlassTest, HasNoHolesOnTheGround) {
  const auto slab = [](float bottom) {
    DrawScene scene;
    scene.environment.strength = 0;
    scene.ground = Ground{0, {0.86f, 0.87f, 0.88f}};
    const std::array<Vector3f, 8> c = {Vector3f(-1, bottom, -1), {-1, bottom, 1}, {1, bottom, 1}, {1, bottom, -1},
                                       Vector3f(-1, 0.05f, -1),  {-1, 0.05f, 1},  {1, 0.05f, 1},  {1, 0.05f, -1}};
    for (const auto& face :
         {std::array{4, 5, 6, 7}, {3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
      for (const int i : {0, 1, 2, 0, 2, 3}) scene.surface.positions.push_back(c[face[i]]);
    scene.surface.flags.assign(12, kClear);
    scene.surface.ids.assign(12, kFront);
    scene.surface.colors.assign(12, {0.55f, 0.8f, 0.7f});
    scene.surface.clear_depth = 0.03f;
    return scene;
  };
  const RenderOptions how = without_shadows(clear_options());
  DrawScene bare = slab(0);
  bare.surface = {};
  const Image ground = picture(bare, how), above = picture(slab(1e-4f), how);
  for (const float bottom : {-1e-4f, 1e-6f, 0.0f, -1e-6f}) {
    const Image lying = picture(slab(bottom), how);
    const IdImage ids = renderer_->ids();
    int inside = 0, holes = 0, off = 0;
    for (int y = kRim; y + kRim < kHeight; ++y)
      for (int x = kRim; x + kRim < kWidth; ++x) {
        if (!all_around(ids, x, y, kFront, true)) continue;
        ++inside;
        holes += lying.pixel(x, y)[0] > ground.pixel(x, y)[0] - 20;
        off += std::abs(lying.pixel(x, y)[0] - above.pixel(x, y)[0]) > 4;
      }
    EXPECT_GT(inside, 2500);
    EXPECT_EQ(holes, 0) << bottom << ": pixels that do not show its color";
    EXPECT_EQ(off, 0) << bottom;
  }
}

/// Adds a box of gray matter, or a clear one.
void add_box(Surface& surface, const Vector3f& low, const Vector3f& high, std::uint8_t flag) {
  const auto corner = [&](int i) {
    return Vector3f(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  };
  for (const auto& face :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    for (const int i : {0, 1, 2, 0, 2, 3}) surface.positions.push_back(corner(face[static_cast<std::size_t>(i)]));
  surface.flags.insert(surface.flags.end(), 12, flag);
  surface.colors.insert(surface.colors.end(), 12, flag ? Rgb{0.62f, 0.81f, 0.82f} : Rgb{0.6f, 0.6f, 0.6f});
}

/// A sheet on a block at a grazing angle, at which the distance varies much within a pixel: its lower face, which would
/// mirror the inside of the sheet elsewhere, does so in no pixel there.
TEST_F(GlassTest, TouchesWithoutSpecks) {
  for (const float rise : {0.1f, 0.15f}) {
    for (const float gap : {1e-5f, 0.0f, -1e-5f}) {
      DrawScene scene;
      scene.surface.clear_depth = 0.06f;
      add_box(scene.surface, {-0.5f, -0.5f, -0.5f}, {0.5f, 0, 0.5f}, 0);
      add_box(scene.surface, {-1, gap, -1}, {1, gap + 0.008f, 1}, kClear);
      renderer_->render(scene, {{0.3f, rise, 2.4f}, {0, 0, 0}, 40}, without_shadows(clear_options(4)));
      const Image image = renderer_->image();
      for (int y = kHeight / 2 - 1; y <= kHeight / 2 + 1; ++y)
        for (int x = kWidth / 2 - 35; x < kWidth / 2 + 35; ++x)
          ASSERT_NEAR(image.pixel(x, y)[0], image.pixel(x + 1, y)[0], 10) << rise << " m, " << gap << " m";
    }
  }
}

/// The slab's faces are turned against the line of sight, so that it bends the look at what is behind.
TEST_F(GlassTest, WhatStandsBeforeItIsSeenOnce) {
  DrawScene scene;
  scene.background = {{0.2f, 0.4f, 0.6f}, {0.2f, 0.4f, 0.6f}};
  const auto square = [&](const Vector3f& middle, const Vector3f& x, const Vector3f& y, bool clear, const Rgb& color) {
    for (const auto& [a, b] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}})
      scene.surface.positions.push_back(middle + static_cast<float>(a) * x + static_cast<float>(b) * y);
    for (int i = 0; i < 2; ++i) {
      scene.surface.flags.push_back(clear ? kClear : 0);
      scene.surface.colors.push_back(color);
      scene.surface.ids.push_back(clear ? kFront : kBehind);
    }
  };
  const Vector3f across(1, 0, 1), up(0, 1, 0);  // turned by 45 degrees
  square({0, 0, -0.5f}, across, up, true, {0.5f, 0.8f, 0.8f});
  square({0, 0, -0.6f}, across, -up, true, {0.5f, 0.8f, 0.8f});
  for (const int samples : {1, 4}) {
    const RenderOptions how = without_shadows(clear_options(samples));
    const Image bare = picture(scene, how);
    const Surface kept = scene.surface;
    square({0, 0, 1}, {0.1f, 0, 0}, {0, 0.2f, 0}, false, {0.9f, 0.1f, 0.1f});
    const Image with = picture(scene, how);
    const IdImage ids = renderer_->ids();
    int covered = 0;
    for (int y = kRim; y + kRim < kHeight; ++y)
      for (int x = kRim; x + kRim < kWidth; ++x) {
        const bool beside = all_around(ids, x, y, kBehind, false);
        covered += !beside;
        for (std::size_t i = 0; i < (beside ? 3 : 0); ++i)
          EXPECT_NEAR(with.pixel(x, y)[i], bare.pixel(x, y)[i], 1) << x << ", " << y;
      }
    EXPECT_GT(covered, 100);
    scene.surface = kept;
  }
}

TEST_F(GlassTest, SeamsInItsFacesAreNotSeen) {
  const DrawScene whole = sheet(camera(), {0.55f, 0.8f, 0.7f}, 0.1f);
  DrawScene parted = whole;
  Surface& surface = parted.surface;
  for (std::size_t i = 0; i < surface.ids.size(); ++i) {
    if (surface.ids[i] != kBack) continue;
    Vector3f* corners = &surface.positions[3 * i];
    const Vector3f middle = (corners[0] + corners[1] + corners[2]) / 3;
    for (std::size_t k = 0; k < 3; ++k) corners[k] += 6e-4f * (middle - corners[k]);  // half a pixel between the two
  }
  for (const int samples : {1, 4})
    EXPECT_LT(off_fraction(picture(whole, clear_options(samples)), picture(parted, clear_options(samples))), 1e-3);
}

TEST_F(GlassTest, TheOrderOfTrianglesMakesNoDifference) {
  const DrawScene scene = sheet(camera(), {0.5f, 0.8f, 0.8f}, 0.1f);
  DrawScene turned = scene;
  Surface& surface = turned.surface;
  for (std::size_t i = 0; i < surface.ids.size() / 2; ++i) {
    const std::size_t j = surface.ids.size() - 1 - i;
    std::swap(surface.ids[i], surface.ids[j]);
    std::swap(surface.flags[i], surface.flags[j]);
    std::swap(surface.colors[i], surface.colors[j]);
    for (std::size_t k = 0; k < 3; ++k) std::swap(surface.positions[3 * i + k], surface.positions[3 * j + k]);
  }
  for (const int samples : {1, 4})
    EXPECT_EQ(off_fraction(picture(scene, clear_options(samples)), picture(turned, clear_options(samples))), 0);
}

TEST_F(GlassTest, WhatIsSeenThroughIsPicked) {
  for (const int samples : {1, 4}) {
    picture(sheet(camera(), {0.5f, 0.8f, 0.8f}, 0.1f), clear_options(samples));
    EXPECT_EQ(renderer_->id_at(kWidth / 2, kHeight / 2), kFront);
  }
}

TEST_F(GlassTest, DraftShowsItOpaque) {
  RenderOptions draft = clear_options();
  draft.quality = Quality::draft;
  DrawScene scene = sheet(camera(), {0.5f, 0.8f, 0.8f}, 0.1f);
  const Image opaque = picture(scene, draft);
  for (std::uint8_t& flags : scene.surface.flags) flags = 0;
  EXPECT_EQ(picture(scene, draft), opaque);
}

TEST_F(GlassTest, CracksInItAreBrighterThanItsSides) {
  DrawScene scene = sheet(camera(), {0.5f, 0.8f, 0.8f}, 0.1f);
  const auto smooth = middle(picture(scene, clear_options()));
  scene.surface.flags[2] |= kCrackFace;
  scene.surface.flags[3] |= kCrackFace;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(middle(picture(scene, clear_options()))[i], 1.1 * smooth[i]);
}

TEST_F(GlassTest, ItsShadowIsLight) {
  DrawScene scene;
  scene.ground = Ground{0};
  scene.surface.positions = {{-1, 0.8f, -1}, {1, 0.8f, -1}, {0, 0.8f, 1}};
  scene.surface.flags = {kClear};
  scene.surface.colors = {{0.5f, 0.8f, 0.8f}};
  const auto taken_light = [&](std::uint8_t flags) {
    scene.surface.flags = {flags};
    RenderOptions how = clear_options();
    const Image shaded = picture(scene, how);
    how.shadows = false;
    const Image lit = picture(scene, how);
    double taken = 0;
    for (std::size_t i = 0; i < lit.rgba.size(); ++i)
      taken += light_shown_as(lit.rgba[i]) - light_shown_as(shaded.rgba[i]);
    return taken;
  };
  const double opaque = taken_light(0), clear = taken_light(kClear);
  EXPECT_GT(opaque, 0);
  EXPECT_NEAR(clear / opaque, 0.3, 0.15);
}

}  // namespace
}  // namespace griffith::render
