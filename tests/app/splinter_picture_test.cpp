#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/output/export_pieces.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/embedded_picture.h"
#include "enclosed_volume.h"
#include "program.h"
#include "renderer/egl_context.h"
#include "renderer/renderer.h"
#include "sim/meshing/surface.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

Scene bricks(double strength) {
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(strength));
  BrickSplinters pattern;
  pattern.size = Vec3(0.38, 0.18, 0.23);
  pattern.mortar = 0.02;
  scene.bodies[0].splinters = pattern;
  return scene;
}

class SplinterPicture : public ::testing::Test {
 protected:
  render::Image picture(const World& world, const EmbeddedDisplay& display, const Scene& scene,
                        const ViewSettings& view) {
    render::Camera camera;
    camera.position = {2, 2, 3};
    camera.target = {0, 1, 0};
    render::RenderOptions options;
    options.width = 320;
    options.height = 240;
    options.edges = view.edges;
    renderer_.render(draw_scene_from_frame(world.frame(), display, scene, view, {TetId(7), NodeId(), Vec3::Zero()}),
                     camera, options);
    return renderer_.image();
  }

  const render::EglContext context_{std::nullopt};
  render::Renderer renderer_;
};

int different_pixels(const render::Image& a, const render::Image& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      int largest = 0;
      for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(int(a.pixel(x, y)[c]) - int(b.pixel(x, y)[c])));
      count += largest > 4;
    }
  return count;
}

TEST_F(SplinterPicture, AnIntactBodyLooksAsWithoutSplinters) {
  const Scene scene = bricks(1);
  World world(scene);
  world.step();
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  for (const char* quantity : {"von_mises", "speed", "body"}) {
    ViewSettings with;
    with.quantity = quantity;
    ViewSettings without = with;
    without.splinters = false;
    const int different =
        different_pixels(picture(world, display, scene, with), picture(world, display, scene, without));
    EXPECT_LE(different, 320 * 240 / 2000) << quantity;
  }
}

TEST_F(SplinterPicture, ABrokenBodyShowsOtherPieces) {
  const Scene scene = bricks(0.02);
  World world(scene);
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  for (int i = 0; i < 30; ++i) world.step();
  ASSERT_GT(world.frame().fragments, 0);
  ViewSettings with;
  with.quantity = "body";
  ViewSettings without = with;
  without.splinters = false;
  EXPECT_GT(different_pixels(picture(world, display, scene, with), picture(world, display, scene, without)), 200);
}

TEST_F(SplinterPicture, BodiesWithoutSplintersShowTheirTets) {
  Scene scene = bricks(1);
  scene.bodies.push_back(testing::wall(Vec3(1, 1, 0.5), 0.5, testing::brick(1)));
  scene.bodies[1].name = "plain";
  scene.bodies[1].position.x() = 5;
  const World world(scene);
  const Frame frame = world.frame();
  const render::DrawScene drawn = draw_scene_from_frame(frame, embedded_display(frame, scene), scene, {}, {});
  EXPECT_FALSE(drawn.surface.ids.empty());
  for (const std::int32_t tet : drawn.surface.ids) EXPECT_EQ(frame.elements.bodies[tet], BodyId(1));
  EXPECT_EQ(drawn.surface.scalars.size(), drawn.surface.ids.size());
  ASSERT_TRUE(drawn.embedded.mesh);
  for (const render::EmbeddedCorner& corner : drawn.embedded.mesh->corners)
    EXPECT_EQ(frame.elements.bodies[corner.tet], BodyId(0));
}

/// A body filled from the surface of a cube.
Scene cube_of_surface(double strength) {
  test_file("cube.obj",
            "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
            "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
  Scene scene = bricks(strength);
  fill_surface(scene, "cube.obj");
  scene.bodies[0].splinters.reset();
  scene.bodies[0].position.setZero();
  scene.bodies[0].rotation_degrees = Vec3(0, 30, 0);
  scene.bodies[0].supports = {{HalfSpaceRegion{Vec3(0, 0.1, 0), -Vec3::UnitY()}}};
  return scene;
}

TEST(SkinPicture, TheSurfaceStandsWhereItsTetsAreAndNoTriangleSpansTwoBodies) {
  const Scene scene = cube_of_surface(0.02);
  World world(scene);
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  ASSERT_EQ(display.authored.skin_parts.size(), 36u);
  const auto drawn = [&] { return draw_scene_from_frame(world.frame(), display, scene, {}, {}); };
  EXPECT_TRUE(drawn().surface.ids.empty());
  const render::DrawScene start = drawn();
  for (const render::EmbeddedCorner& corner : start.embedded.mesh->corners) {
    Eigen::Vector3f position = Eigen::Vector3f::Zero();
    for (int i = 0; i < 4; ++i)
      position += corner.weights[i] * start.embedded.points[start.embedded.tets[corner.tet][i]];
    EXPECT_LT((position - corner.rest).norm(), 1e-3f);
  }
  for (int i = 0; i < 30; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.fragments, 0);
  for (const SkinPart& part : display.authored.skin_parts)
    EXPECT_EQ(frame.elements.bodies[skin_carrier(frame, part)], frame.elements.bodies[part.owner]);
  EXPECT_FALSE(drawn().surface.ids.empty());  // cracks are laid bare
  EXPECT_FALSE(drawn().surface.closed);
  EXPECT_FALSE(drawn().embedded.closed);
}

/// Neighbors of a smooth surface share a normal; those at an edge of a cube do not.
TEST(SkinPicture, CornersHaveTheSurfacesNormals) {
  const Scene scene = cube_of_surface(1);
  const World world(scene);
  const std::vector<Skin> skins = make_skins(world.frame(), scene);
  ASSERT_EQ(skins.size(), 1u);
  ASSERT_EQ(skins[0].corners.size(), 36u);
  for (std::size_t i = 0; i < skins[0].corners.size(); i += 3) {
    const auto rest = [&](std::size_t k) { return skins[0].corners[i + k].rest; };
    const Vec3 normal = (rest(1) - rest(0)).cross(rest(2) - rest(0)).normalized();
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((skins[0].corners[i + k].normal - normal).norm(), 1e-6);
  }
}

/// A square with texture coordinates as the lid of a cube.
TEST(SkinPicture, TextureCoordinatesAreDrawnAndExported) {
  Scene scene = cube_of_surface(0.2);
  test_file("cube.obj",
            "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            "f 1/1 2/2 3/3 4/4\nf 8/1 7/2 6/3 5/4\nf 1/1 5/2 6/3 2/4\nf 2/1 6/2 7/3 3/4\nf 3/1 7/2 8/3 4/4\nf 4/1 8/2 "
            "5/3 1/4\n");
  World world(scene);
  const std::vector<Skin> skins = make_skins(world.frame(), scene);
  ASSERT_TRUE(skins[0].has_uvs);
  scene.view.quantity = "texture";
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, scene.view, {});
  EXPECT_TRUE(drawn.embedded.checker);
  const std::vector<Skin>& parted = display.shards.skins();
  const std::size_t first = display.shards.set().corners.size();  // of those of the skin
  for (std::size_t i = 0; i < parted[0].corners.size(); ++i)
    EXPECT_EQ(drawn.embedded.mesh->corners[first + i].uv, parted[0].corners[i].uv.cast<float>());
  for (int i = 0; i < 30; ++i) world.step();
  const std::filesystem::path folder = test_folder() / "textured";
  std::filesystem::remove_all(folder);  // what an earlier run left there
  export_pieces(folder, world.frame(), display.shards);
  double area = 0;  // of the texture, which each of the six sides shows once
  int pieces = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const TriangleSurface piece = read_surface(entry.path());
    ++pieces;
    for (const auto& [a, b, c] : piece.uvs) area += std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
  }
  EXPECT_GT(pieces, 1);
  EXPECT_NEAR(area, 6, 1e-5);
}

TEST(ExportPieces, AnIntactBodyEnclosesItsVolume) {
  Scene scene = bricks(1);
  scene.gravity.setZero();
  const World with(scene);
  EXPECT_NEAR(enclosed_volume(piece_surfaces(with.frame())[0]), 2, 1e-5);
  scene.bodies[0].splinters.reset();
  const World without(scene);
  EXPECT_NEAR(enclosed_volume(piece_surfaces(without.frame())[0]), 2, 1e-9);
}

TEST(ExportPieces, AnIntactSkinEnclosesTheSurfacesVolume) {
  Scene scene = cube_of_surface(1);
  scene.gravity.setZero();
  const World world(scene);
  EXPECT_NEAR(enclosed_volume(piece_surfaces(world.frame(), make_skins(world.frame(), scene))[0]), 8, 1e-5);
}

TEST(ExportPieces, PiecesShareOutTheBodyAndAreFiles) {
  World world(bricks(0.02));
  for (int i = 0; i < 30; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.bodies.size(), 5u);
  const std::filesystem::path folder = test_folder() / "pieces";
  std::filesystem::remove_all(folder);  // of an earlier run
  export_pieces(folder, frame);
  double sum = 0;
  std::size_t files = 0;
  for (const PieceSurface& surface : piece_surfaces(frame)) {
    sum += enclosed_volume(surface);
    files += !surface.polygons.empty();
  }
  EXPECT_NEAR(sum, 2, 0.02);  // tets are stretched a little
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) found += entry.path().extension() == ".obj";
  EXPECT_EQ(found, files);
}

TEST(ExportPieces, TheCommandWritesThem) {
  const std::filesystem::path folder = test_folder() / "made/pieces";
  const Outcome outcome =
      run_program("simulate " + small_wall_file().string() + " --frames 2 --export-pieces " + folder.string());
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "body_0000.obj"));
  const std::filesystem::path no_folder = test_file("taken", "a file");
  EXPECT_EQ(
      run_program("simulate " + small_wall_file().string() + " --frames 0 --export-pieces " + no_folder.string()).code,
      2);
}

}  // namespace
}  // namespace griffith::app
