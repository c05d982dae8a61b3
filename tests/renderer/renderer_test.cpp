#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <regex>
#include <set>

#include "renderer/target.h"
#include "tests/renderer/renderer_fixture.h"
#include "tests/renderer/wall_scene.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;
using Pixel = std::array<std::uint8_t, 4>;

class RendererTest : public RendererFixture {
 protected:
  static Image picture(const DrawScene& scene, const RenderOptions& how = options()) {
    return RendererFixture::picture(scene, how);
  }
};

DrawScene screen_filling_square(const Camera& camera) {
  DrawScene scene;
  scene.surface.positions = filling_square(camera);
  return scene;
}

Pixel bytes(const Rgb& color) {
  const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
  return {byte(color.r), byte(color.g), byte(color.b), 255};
}

TEST_F(RendererTest, PictureHasItsSizeAndManyColors) {
  const Image image = picture(wall_scene());
  EXPECT_EQ(image.width, kWidth);
  EXPECT_EQ(image.height, kHeight);
  ASSERT_EQ(image.rgba.size(), 4u * kWidth * kHeight);
  std::set<Pixel> colors;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      colors.insert(image.pixel(x, y));
      ASSERT_EQ(image.pixel(x, y)[3], 255) << "not opaque at " << x << ", " << y;
    }
  }
  EXPECT_GT(colors.size(), 200u);
}

TEST_F(RendererTest, SameSceneTwiceGivesTheSameBytes) {
  for (const int samples : {1, 4}) {
    RenderOptions how = options();
    how.samples = samples;
    const Image first = picture(wall_scene(), how);
    const Image other = picture(scalar_wall_scene(), how);
    EXPECT_EQ(picture(wall_scene(), how), first);
    EXPECT_NE(other, first);
  }
}

TEST_F(RendererTest, PicturesOfOneUploadAreThoseOfTheirCameras) {
  const DrawScene scene = wall_scene();
  RenderOptions how = options();
  how.quality = Quality::standard;
  RenderOptions smaller = how;
  smaller.width = kWidth / 2;
  const Camera cameras[] = {camera(), orbit(camera(), 0.7f, 0.2f), far_camera(camera(), Vector3f::UnitY())};
  std::vector<Image> alone;
  for (const Camera& from : cameras) {
    Renderer renderer;
    renderer.render(scene, from, from.vertical_fov < 5 ? smaller : how);
    alone.push_back(renderer.image());
  }
  Renderer renderer;
  renderer.upload(scene, how.pixel_scale);
  for (const std::size_t i : {2, 0, 1})
    renderer.draw(scene, cameras[i], cameras[i].vertical_fov < 5 ? smaller : how, i);
  for (const std::size_t i : {0, 1, 2}) EXPECT_EQ(renderer.image(i), alone[i]) << i;
}

TEST_F(RendererTest, IdsAreThoseOfWhatIsSeen) {
  for (const int samples : {1, 4}) {
    RenderOptions how = options();
    how.samples = samples;
    DrawScene scene = wall_scene();
    scene.spheres[0].center = camera().target;
    picture(scene, how);
    // The wall's nearest face is 15 cm before the ball's center, its radius 22 cm.
    EXPECT_EQ(renderer_->id_at(kWidth / 2, kHeight / 2), kBallId);
    EXPECT_EQ(renderer_->id_at(2, 2), kNoId);
    EXPECT_EQ(renderer_->id_at(-1, 5), kNoId);
    EXPECT_EQ(renderer_->id_at(kWidth, 5), kNoId);
    std::set<std::int32_t> seen;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) seen.insert(renderer_->id_at(x, y));
    }
    EXPECT_GT(seen.size(), 100u);
    for (const std::int32_t id : seen) {
      EXPECT_TRUE(id == kNoId || id == kBallId || id == kBallId + 1 ||
                  (0 <= id && id < static_cast<std::int32_t>(scene.surface.ids.size())))
          << id;
    }
  }
}

TEST_F(RendererTest, UnlitScalarsHaveTheLegendsColorToTheByte) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-0.1f, 1.1f);
  RenderOptions how = options();
  how.unlit_scalars = true;
  for (const ColorMap map : kColorMaps) {
    for (const int samples : {1, 4}) {
      how.samples = samples;
      DrawScene scene = screen_filling_square(camera());
      scene.spheres = {{camera().target + Vector3f(0, 1, 3), 0.3f}};  // its shadow must not show
      scene.surface.scalar_style = {map, -40, 60, "", ""};
      scene.surface.scalars = {100 * unit(random) - 40, 100 * unit(random) - 40};
      const Image image = picture(scene, how);
      const auto expected = [&](int triangle) {
        return bytes(color_map_color(map, (scene.surface.scalars[triangle] + 40) / 100));
      };
      EXPECT_EQ(image.pixel(kWidth - 5, kHeight - 5), expected(0));
      EXPECT_EQ(image.pixel(5, 5), expected(1));
    }
  }
}

TEST_F(RendererTest, InterpolatedUnlitScalarsStayWithinTheLegend) {
  RenderOptions how = options();
  how.unlit_scalars = true;
  DrawScene scene = screen_filling_square(camera());
  scene.surface.scalars = {0.2f, 0.6f, 0.9f, 0.2f, 0.9f, 0.5f};
  const Image image = picture(scene, how);
  std::set<Pixel> legend;
  for (int entry = 0; entry < kColorTableSize; ++entry) {
    legend.insert(bytes(color_map_color(ColorMap::viridis, (static_cast<float>(entry) + 0.5f) / kColorTableSize)));
  }
  std::set<Pixel> seen;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) seen.insert(image.pixel(x, y));
  }
  EXPECT_GT(seen.size(), 10u);
  for (const Pixel& pixel : seen) EXPECT_TRUE(legend.contains(pixel));
}

TEST_F(RendererTest, NanHasItsOwnColor) {
  RenderOptions how = options();
  how.unlit_scalars = true;
  DrawScene scene = screen_filling_square(camera());
  scene.surface.scalars.assign(2, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(picture(scene, how).pixel(7, 9), bytes(kNanColor));
}

TEST_F(RendererTest, LitScalarsKeepTheirOrderOfBrightness) {
  DrawScene scene = screen_filling_square(camera());
  scene.surface.scalars = {0.3f, 0.4f};
  const Image image = picture(scene);
  EXPECT_LT(image.pixel(kWidth - 5, kHeight - 5)[1], image.pixel(5, 5)[1]);
}

TEST_F(RendererTest, ShadowsDarkenTheGroundOnly) {
  DrawScene scene;
  scene.spheres = {{{0, 1.2f, 0}, 0.4f}};
  scene.ground = Ground{};
  RenderOptions how = options();
  const Image with = picture(scene, how);
  how.shadows = false;
  const Image without = picture(scene, how);
  int darker = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_LE(with.pixel(x, y)[1], without.pixel(x, y)[1]);
      darker += with.pixel(x, y)[1] + 20 < without.pixel(x, y)[1];
    }
  }
  EXPECT_GT(darker, 100);
  EXPECT_LT(darker, kWidth * kHeight / 10);
}

TEST_F(RendererTest, PuffsAreSeenThroughAndNotPicked) {
  DrawScene scene;
  scene.spheres = {{{0, 1.2f, 0}, 0.8f, {0.1f, 0.1f, 0.1f}, 7}};
  const Image bare = picture(scene, options(1));
  const auto brightness = [&](float opacity, float distance) {
    const Vector3f towards_eye = (camera().position - camera().target).normalized();
    scene.puffs = {{Vector3f(0, 1.2f, 0) + distance * towards_eye, 0.6f, {0.9f, 0.9f, 0.9f}, opacity}};
    const Image image = picture(scene, options(1));
    EXPECT_EQ(renderer_->id_at(kWidth / 2, kHeight / 2), 7);
    return static_cast<int>(image.pixel(kWidth / 2, kHeight / 2)[0]);
  };
  const int without = bare.pixel(kWidth / 2, kHeight / 2)[0];
  EXPECT_EQ(brightness(0, 1.5f), without);
  EXPECT_GT(brightness(0.3f, 1.5f), without + 5);
  EXPECT_GT(brightness(0.9f, 1.5f), brightness(0.3f, 1.5f) + 5);
  EXPECT_EQ(brightness(0.9f, -1.5f), without) << "behind the sphere";
}

/// From standard quality on there is no border where it goes into a body.
TEST_F(RendererTest, PuffsGrowFaintTowardWhatTheyLieOn) {
  DrawScene bare = screen_filling_square(camera());
  bare.surface.color = {0.1f, 0.1f, 0.1f};
  const Vector3f towards_eye = (camera().position - camera().target).normalized();
  const auto effect = [&](Quality quality, float distance) {
    RenderOptions how = options(1);
    how.quality = quality;
    DrawScene scene = bare;
    scene.puffs = {{camera().target + distance * towards_eye, 0.6f, {0.9f, 0.9f, 0.9f}, 0.9f}};
    const int with = picture(scene, how).pixel(kWidth / 2, kHeight / 2)[0];
    return with - picture(bare, how).pixel(kWidth / 2, kHeight / 2)[0];
  };
  for (const Quality quality : {Quality::standard, Quality::high}) {
    EXPECT_LE(effect(quality, 0.01f), 8);
    EXPECT_GT(effect(quality, 0.2f), effect(quality, 0.01f) + 8);
    EXPECT_GT(effect(quality, 0.6f), effect(quality, 0.2f) + 8);
  }
  EXPECT_GT(effect(Quality::draft, 0.01f), 50);
}

/// Each changes a pixel by less than a step of its color; together they must change all three channels in proportion.
/// Rounded to the nearest step, green and blue would be some 50 steps off.
TEST_F(RendererTest, ManyFaintPuffsFadeInTheirOwnHue) {
  constexpr int kPuffs = 200;
  constexpr float kOpacity = 0.004f;
  const Puff puff{camera().target, 4, {0.8f, 0.4f, 0.3f}, kOpacity};
  const auto mean_color = [&](const std::vector<Puff>& puffs) {
    DrawScene scene;
    scene.puffs = puffs;
    const Image image = picture(scene, options(1));
    Vector3f sum = Vector3f::Zero();
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x)
        for (int i = 0; i < 3; ++i) sum[i] += image.pixel(kWidth / 2 + x, kHeight / 2 + y)[i];
    return Vector3f(sum / 81);
  };
  Puff dense = puff;
  dense.opacity = 1;
  const float left = std::pow(1 - kOpacity, kPuffs);
  const Vector3f expected = left * mean_color({}) + (1 - left) * mean_color({dense});
  std::vector<Puff> puffs(kPuffs, puff);
  for (int i = 0; i < kPuffs; ++i) puffs[i].center.x() += 1e-3f * static_cast<float>(i);
  const Vector3f faint = mean_color(puffs);
  EXPECT_LT((faint - expected).cwiseAbs().maxCoeff(), 10)
      << faint.transpose() << " instead of " << expected.transpose();
}

TEST_F(RendererTest, MarkedEdgesAreDrawnAndOnlyThose) {
  DrawScene scene = screen_filling_square(camera());
  RenderOptions how = options();
  const Image none = picture(scene, how);
  scene.surface.flags = {0, 0};
  EXPECT_EQ(picture(scene, how), none);
  scene.surface.flags = {kEdge1, kEdge2};  // the shared diagonal
  const Image diagonal = picture(scene, how);
  const double changed = off_fraction(none, diagonal) * kWidth * kHeight;
  EXPECT_GT(changed, kHeight / 2);
  EXPECT_LT(changed, 4 * kWidth);
  how.edges = false;
  EXPECT_EQ(picture(scene, how), none);
}

TEST_F(RendererTest, LinesAndPointsCarryIdsAndColors) {
  DrawScene scene;
  const Camera from = camera();
  scene.lines = {{from.target - Vector3f(1, 0, 0), from.target + Vector3f(1, 0, 0), {1, 0, 0}, 11}};
  scene.line_width = 5;
  scene.points = {{from.target, 21, {0, 0, 1}, 12}};
  const Image image = picture(scene);
  EXPECT_EQ(image.pixel(kWidth / 2 + 8, kHeight / 2), (Pixel{0, 0, 255, 255}));
  EXPECT_EQ(renderer_->id_at(kWidth / 2 + 8, kHeight / 2), 12);
  int line_pixels = 0;
  for (int x = 0; x < kWidth; ++x) line_pixels += image.pixel(x, kHeight / 2) == Pixel{255, 0, 0, 255};
  EXPECT_GT(line_pixels, 10);
}

TEST_F(RendererTest, LinesShowOnASurfaceAndHideBehindIt) {
  DrawScene scene = wall_scene();
  scene.points.clear();
  const auto line_pixels = [&](float z) {
    scene.lines = {{{-1.5f, 0.6f, z}, {1.5f, 0.6f, z}, {1, 0, 0}, 2000000}};
    picture(scene);
    int seen = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) seen += renderer_->id_at(x, y) == 2000000;
    }
    return seen;
  };
  EXPECT_GT(line_pixels(0.15f), 100);  // on the wall's face
  EXPECT_EQ(line_pixels(0.10f), 0);    // 5 cm inside of the wall, 6 m away
}

TEST_F(RendererTest, ALineThroughTheCameraIsClippedNotMirrored) {
  DrawScene scene;
  const Camera from = camera();
  const Vector3f forward = (from.target - from.position).normalized();
  const Vector3f right = forward.cross(Vector3f::UnitY()).normalized();
  scene.lines = {{from.position - 5 * forward + right, from.target + right, {1, 0, 0}, 5}};
  picture(scene);
  for (int x = 0; x < kWidth / 2; ++x) EXPECT_EQ(renderer_->id_at(x, kHeight / 2), kNoId);
  EXPECT_EQ(renderer_->id_at(kWidth - 1, kHeight / 2), 5);
}

TEST_F(RendererTest, EmptyAndNonFiniteScenesAreDrawn) {
  const Image background = picture(DrawScene{});
  DrawScene broken;
  broken.surface.positions.assign(3, Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  broken.surface.scalars = {1};
  EXPECT_EQ(picture(broken), background);
  EXPECT_TRUE(bounds(broken).isEmpty());
}

TEST_F(RendererTest, SizesMayChangeFromPictureToPicture) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 6; ++trial) {
    RenderOptions how;
    how.width = 1 + static_cast<int>(random() % 90);
    how.height = 1 + static_cast<int>(random() % 90);
    how.samples = 1 + static_cast<int>(random() % 8);
    const Image image = picture(wall_scene(), how);
    EXPECT_EQ(image.width, how.width);
    EXPECT_EQ(image.height, how.height);
  }
}

TEST_F(RendererTest, LeavesFramebufferAndViewportAsTheyWere) {
  const Target other(50, 40);
  other.bind();
  GLint before = 0, after = 0, viewport[4] = {};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  picture(wall_scene());
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &after);
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(after, before);
  EXPECT_EQ(viewport[2], 50);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST(RendererFolder, IncludesNeitherPhysicsNorUserInterface) {
  const std::regex forbidden(R"(#include\s*[<"](sim/|ui/|app/|imgui|GLFW))");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GRIFFITH_SOURCE_DIR "/renderer")) {
    if (!entry.is_regular_file()) continue;
    ++files;
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_FALSE(std::regex_search(text, forbidden)) << entry.path();
  }
  EXPECT_GT(files, 20);
}

}  // namespace
}  // namespace griffith::render
