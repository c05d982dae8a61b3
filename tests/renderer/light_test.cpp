#include <cmath>

#include "tests/renderer/renderer_fixture.h"
#include "tests/renderer/wall_scene.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

class LightTest : public RendererFixture {
 protected:
  static RenderOptions options_of(Quality quality) {
    RenderOptions how = options();
    how.quality = quality;
    how.edges = false;
    return how;
  }
};

constexpr Quality kAll[] = {Quality::draft, Quality::standard, Quality::high};
constexpr Quality kWithEffects[] = {Quality::standard, Quality::high};

void add_rectangle(Surface& surface, const Vector3f& corner, const Vector3f& a, const Vector3f& b) {
  surface.positions.insert(surface.positions.end(),
                           {corner, corner + a, corner + a + b, corner, corner + a + b, corner + b});
}

int brightness(const Image& image, int x, int y) {
  const auto pixel = image.pixel(x, y);
  return pixel[0] + pixel[1] + pixel[2];
}

TEST_F(LightTest, NothingOccludesAPlane) {
  DrawScene scene;
  scene.surface.positions = filling_square(camera());
  for (const Quality quality : kWithEffects) {
    const Image image = picture(scene, options_of(quality));
    const int middle = brightness(image, kWidth / 2, kHeight / 2);
    for (int y = 0; y < kHeight; y += 7)
      for (int x = 0; x < kWidth; x += 7) EXPECT_NEAR(brightness(image, x, y), middle, 3) << x << ", " << y;
  }
}

TEST_F(LightTest, ACornerIsDarkerThanThePlaneBesideIt) {
  DrawScene scene;  // a floor, with a wall behind it that casts no shadow on it: the lamp stands before it
  add_rectangle(scene.surface, {-3, 0, -1}, {6, 0, 0}, {0, 0, 4});
  RenderOptions how = options_of(Quality::standard);
  how.shadows = false;
  const Camera above = {{0, 3, 4}, {0, 0, 0}, 40};
  const auto floor_near_wall = [&](const DrawScene& drawn) {
    renderer_->render(drawn, above, how);
    const Image image = renderer_->image();
    const auto row = [&](float z) {  // where the camera sees the floor at that z, in the middle
      const Mat4 matrix = projection_matrix(above, float(kWidth) / kHeight, bounds(drawn)) * view_matrix(above);
      const Eigen::Vector4f clip = matrix * Eigen::Vector4f(0, 0, z, 1);
      return static_cast<int>(kHeight * (0.5f - 0.5f * clip.y() / clip.w()));
    };
    return brightness(image, kWidth / 2, row(-0.9f)) - brightness(image, kWidth / 2, row(0.8f));
  };
  EXPECT_NEAR(floor_near_wall(scene), 0, 3);
  add_rectangle(scene.surface, {-3, 0, -1}, {0, 2, 0}, {6, 0, 0});
  EXPECT_LT(floor_near_wall(scene), -20);
  how.quality = Quality::draft;
  EXPECT_NEAR(floor_near_wall(scene), 0, 3);
}

TEST_F(LightTest, AShadowIsSofterTheFartherAwayItsCasterIs) {
  // Pixels of the ground's row under a ball's shadow that are neither in full light nor in full shadow.
  const auto penumbra = [](Quality quality, float height) {
    DrawScene scene;
    scene.ground = Ground{0};
    scene.spheres = {{{0.53f * height, height, 0.65f * height}, 0.4f}};
    RenderOptions how = options_of(quality);
    const Camera above = {{0.01f, 6, 0}, {0, 0, 0}, 40};
    const auto row = [&] {
      renderer_->render(scene, above, how);
      return renderer_->image();
    };
    const Image shaded = row();
    how.shadows = false;
    const Image lit = row();
    int partly = 0, darkest = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (renderer_->id_at(x, y) == kNoId)
          darkest = std::max(darkest, brightness(lit, x, y) - brightness(shaded, x, y));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const int loss = brightness(lit, x, y) - brightness(shaded, x, y);
        partly += loss > 0.15 * darkest && loss < 0.85 * darkest;
      }
    EXPECT_GT(darkest, 40);
    return partly;
  };
  for (const Quality quality : kWithEffects) EXPECT_GT(penumbra(quality, 2.5f), 1.5 * penumbra(quality, 0.9f));
}

/// The shadow map of a small picture has fewer texels.
TEST_F(LightTest, AShadowInADraftIsAsLargeInAPictureOfAnySize) {
  const auto shaded_share = [](int scale) {
    DrawScene scene;
    scene.ground = Ground{0};
    scene.spheres = {{{-1, 1, 0}, 0.7f}};
    RenderOptions how = options_of(Quality::draft);
    how.width *= scale;
    how.height *= scale;
    const Image shaded = picture(scene, how);
    how.shadows = false;
    const Image lit = picture(scene, how);
    int count = 0;
    for (int y = 0; y < how.height; ++y)
      for (int x = 0; x < how.width; ++x) count += brightness(lit, x, y) - brightness(shaded, x, y) > 60;
    return count / static_cast<double>(how.width * how.height);
  };
  EXPECT_GT(shaded_share(1), 0.005);
  EXPECT_NEAR(shaded_share(1) / shaded_share(4), 1, 0.03);
}

/// A polished and a dull ball.
DrawScene two_balls() {
  DrawScene scene;
  scene.spheres = {{{-0.7f, 1.2f, 0}, 0.6f, {0.7f, 0.7f, 0.7f}, 1}, {{0.7f, 1.2f, 0}, 0.6f, {0.7f, 0.7f, 0.7f}, 2}};
  scene.spheres[0].metal = 1;
  scene.spheres[0].roughness = 0;
  scene.spheres[1].roughness = 1;
  return scene;
}

TEST_F(LightTest, SurroundingsLightAndAreMirroredButNotInADraft) {
  DrawScene scene = two_balls();
  for (const Quality quality : kAll) {
    const Image bright = picture(scene, options_of(quality));
    DrawScene dark = scene, outdoors = scene;
    dark.environment.strength = 0;
    outdoors.environment.kind = Environment::Kind::sky;
    const bool is_full = quality != Quality::draft;
    EXPECT_EQ(off_fraction(picture(dark, options_of(quality)), bright) > 0.05, is_full);
    EXPECT_EQ(off_fraction(picture(outdoors, options_of(quality)), bright) > 0.05, is_full);
  }
}

/// So that pictures before other backgrounds can be cut out.
TEST_F(LightTest, TheBackgroundIsNotMirrored) {
  DrawScene scene = two_balls();
  scene.background = {{0, 0, 0}, {0, 0, 0}};
  const Image on_black = picture(scene, options_of(Quality::standard));
  const IdImage ids = renderer_->ids();
  scene.background = {{1, 1, 1}, {1, 1, 1}};
  const Image on_white = picture(scene, options_of(Quality::standard));
  int compared = 0;
  for (int y = 1; y + 1 < kHeight; ++y)
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto id_at = [&](int i, int j) { return ids.ids[static_cast<std::size_t>(j * kWidth + i)]; };
      const bool inside = id_at(x, y) != kNoId && id_at(x - 1, y) != kNoId && id_at(x + 1, y) != kNoId &&
                          id_at(x, y - 1) != kNoId && id_at(x, y + 1) != kNoId;
      compared += inside;
      if (inside) {
        EXPECT_EQ(on_black.pixel(x, y), on_white.pixel(x, y)) << x << ", " << y;
      }
    }
  EXPECT_GT(compared, 2000);
}

TEST_F(LightTest, TheSkyIsSeenBehindEverything) {
  DrawScene scene = two_balls();
  scene.environment.kind = Environment::Kind::sky;
  scene.background.is_sky = true;
  const Camera level = {{0, 1, 6}, {0, 1, 0}, 40};
  renderer_->render(scene, level, options_of(Quality::standard));
  const Image image = renderer_->image();
  const auto top = image.pixel(3, 3), horizon = image.pixel(3, kHeight / 2 - 12);
  EXPECT_GT(top[2], top[0] + 30) << "blue above";
  EXPECT_GT(brightness(image, 3, kHeight / 2 - 12), brightness(image, 3, 3)) << "brighter at the horizon";
  EXPECT_LT(horizon[2] - horizon[0], top[2] - top[0]);
}

TEST_F(LightTest, UnlitScalarsAreTheSameBytesInEveryQuality) {
  DrawScene scene = scalar_wall_scene();
  scene.ground.reset();
  scene.spheres.clear();
  RenderOptions how = options_of(Quality::draft);
  how.unlit_scalars = true;
  const Image draft = picture(scene, how);
  for (const Quality quality : kAll) {
    how.quality = quality;
    EXPECT_EQ(picture(scene, how), draft);
  }
}

TEST_F(LightTest, QualitiesDifferAndEachIsTheSameAgain) {
  const Image draft = picture(wall_scene(), options_of(Quality::draft));
  for (const Quality quality : kWithEffects) {
    const Image image = picture(wall_scene(), options_of(quality));
    EXPECT_GT(off_fraction(image, draft), 0.05);
    picture(wall_scene(), options_of(Quality::draft));
    EXPECT_EQ(picture(wall_scene(), options_of(quality)), image);
  }
}

TEST_F(LightTest, IdsAreTheSameInEveryQuality) {
  picture(wall_scene(), options_of(Quality::draft));
  const IdImage draft = renderer_->ids();
  for (const Quality quality : kWithEffects) {
    picture(wall_scene(), options_of(quality));
    EXPECT_EQ(renderer_->ids().ids, draft.ids);
  }
}

}  // namespace
}  // namespace griffith::render
