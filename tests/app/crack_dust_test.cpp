#include "app/picture/crack_dust.h"

#include <gtest/gtest.h>

#include "app/bake/barycentric.h"
#include "app/picture/draw_scene_from_frame.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

constexpr double kPuffTime = 0.9;  ///< [s]; see crack_dust.cpp

Scene shot_wall(const Material& material) {
  Scene scene = testing::shot_wall(Vec3(2, 2, 0.5), 0.5, material);
  scene.view.quantity = "material";
  return scene;
}

/// A wall into which a ball has made cracks.
World cracked(const Scene& scene) {
  World world(scene);
  for (int i = 0; i < 60 && world.frame().crack_events.empty(); ++i) world.step();
  EXPECT_FALSE(world.frame().crack_events.empty());
  return world;
}

Material preset(const char* key, double strength) {
  Material material = find_material_preset(key).value();
  material.tensile_strength = strength;
  return material;
}

TEST(CrackDust, IsNotThereWithoutCracks) {
  const Scene scene = shot_wall(preset("brick", 1e12));
  const World world(scene);
  const CrackDust dust = crack_dust(world.frame(), scene);
  EXPECT_TRUE(dust.puffs.empty());
  EXPECT_TRUE(dust.crumbs.empty());
}

TEST(CrackDust, FollowsFromTheFrameAlone) {
  const Scene scene = shot_wall(preset("brick", 1e4));
  const World one = cracked(scene), other = cracked(scene);
  const CrackDust a = crack_dust(one.frame(), scene), b = crack_dust(other.frame(), scene);
  ASSERT_FALSE(a.puffs.empty());
  ASSERT_EQ(a.puffs.size(), b.puffs.size());
  ASSERT_EQ(a.crumbs.size(), b.crumbs.size());
  for (std::size_t i = 0; i < a.puffs.size(); ++i) EXPECT_EQ(a.puffs[i].center, b.puffs[i].center);
  for (std::size_t i = 0; i < a.crumbs.size(); ++i) EXPECT_EQ(a.crumbs[i].center, b.crumbs[i].center);
}

TEST(CrackDust, BeginsAtItsCrackAndStaysAboveTheGround) {
  const Scene scene = shot_wall(preset("brick", 1e4));
  World world = cracked(scene);
  for (int step = 0; step < 40; ++step, world.step()) {
    const Frame frame = world.frame();
    for (const render::Sphere& crumb : crack_dust(frame, scene).crumbs) {
      EXPECT_GE(crumb.center.y(), static_cast<float>(scene.ground->height));
      double nearest = std::numeric_limits<double>::infinity();
      for (const CrackEvent& event : frame.crack_events) {
        constexpr double kFastest = 6 * 1.7 * 2.3;  // [m/s]
        const double age = frame.time - event.time, size = 0.5;
        const double reach = kFastest * age + 0.5 * scene.gravity.norm() * age * age + size;
        nearest = std::min(nearest, (crumb.center.cast<double>() - event.position).norm() - reach);
      }
      EXPECT_LE(nearest, 0);
    }
  }
}

TEST(CrackDust, ComesOutOfCracksThatAreOpenAlone) {
  const Scene scene = shot_wall(preset("brick", 1e4));
  World world = cracked(scene);
  for (int step = 0; step < 10; ++step) world.step();
  Frame frame = world.frame();
  EXPECT_FALSE(crack_dust(frame, scene).puffs.empty());
  frame.nodes.positions = frame.nodes.rest_positions;  // all pieces where they were
  EXPECT_TRUE(crack_dust(frame, scene).puffs.empty());
  EXPECT_TRUE(crack_dust(frame, scene).crumbs.empty());
}

/// A crumb is nowhere inside of a body, as bodies lie then.
TEST(CrackDust, CrumbsDoNotFallThroughBodies) {
  const Scene scene = shot_wall(preset("brick", 1e4));
  World world = cracked(scene);
  for (int step = 0; step < 40; ++step) world.step();
  const Frame frame = world.frame();
  const auto depth = [&](const Vec3& place) {
    double deepest = -1;
    for (const std::array<NodeId, 4>& tet : frame.elements.tets) {
      Corners corners;
      for (int i = 0; i < 4; ++i) corners.col(i) = frame.nodes.positions[tet[i]];
      deepest = std::max(deepest, barycentric(corners, place).minCoeff());
    }
    return deepest;
  };
  const std::vector<render::Sphere> crumbs = crack_dust(frame, scene).crumbs;
  ASSERT_GT(crumbs.size(), 10u);
  for (const render::Sphere& crumb : crumbs) {
    if (crumb.center.y() > 0.05f) {
      EXPECT_LT(depth(crumb.center.cast<double>()), 0.02);
    }
  }
}

TEST(CrackDust, FadesAndLeavesItsCrumbs) {
  Scene scene = shot_wall(preset("brick", 1e4));
  World world = cracked(scene);
  const auto is_settled = [&] { return world.frame().time - world.frame().crack_events.back().time > kPuffTime; };
  for (int i = 0; i < 1000 && !is_settled(); ++i) world.step();
  ASSERT_TRUE(is_settled());
  const CrackDust dust = crack_dust(world.frame(), scene);
  EXPECT_TRUE(dust.puffs.empty());
  EXPECT_FALSE(dust.crumbs.empty());
}

TEST(CrackDust, SuitsTheMaterial) {
  const Scene glass = shot_wall(preset("soda_lime_glass", 1e4));
  const CrackDust splinters = crack_dust(cracked(glass).frame(), glass);
  EXPECT_TRUE(splinters.puffs.empty());
  EXPECT_FALSE(splinters.crumbs.empty());
  const Scene iron = shot_wall(preset("grey_cast_iron", 1e4));
  const CrackDust none = crack_dust(cracked(iron).frame(), iron);
  EXPECT_TRUE(none.puffs.empty());
  EXPECT_TRUE(none.crumbs.empty());
}

TEST(CrackDust, IsDrawnInNaturalColorsAloneAndWhereItIsWanted) {
  const Scene scene = shot_wall(preset("brick", 1e4));
  const World world = cracked(scene);
  const EmbeddedDisplay display = embedded_display(World(scene).frame(), scene);
  const auto is_drawn = [&](auto change) {
    ViewSettings view = scene.view;
    change(view);
    const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, view, {});
    EXPECT_EQ(drawn.puffs.empty(), drawn.crumbs.empty());
    EXPECT_EQ(drawn.spheres.size(), world.frame().projectiles.size());
    return !drawn.puffs.empty();
  };
  EXPECT_TRUE(is_drawn([](ViewSettings&) {}));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.dust = false; }));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.quality = PictureQuality::draft; }));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.quantity = "von_mises"; }));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.quantity = "tet"; }));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.explode = 1; }));
  EXPECT_FALSE(is_drawn([](ViewSettings& view) { view.layers = {ViewLayer::supports}; }));
}

}  // namespace
}  // namespace griffith::app
