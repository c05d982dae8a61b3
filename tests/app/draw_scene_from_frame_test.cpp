#include "app/picture/draw_scene_from_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "app/picture/natural_materials.h"
#include "enclosed_volume.h"
#include "program.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

/// A frame with one inner face cut open, on one of its sides.
class CutFrame {
 public:
  explicit CutFrame(const Frame& whole)
      : neighbors_(whole.elements.neighbors.begin(), whole.elements.neighbors.end()), frame_(whole) {
    std::size_t face = 0;
    while (!neighbors_[tet_][face].valid())
      if (++face == 4) face = 0, ++tet_;
    neighbors_[tet_][face] = {};
    frame_.elements.neighbors = neighbors_;
  }
  CutFrame(const CutFrame&) = delete;
  CutFrame& operator=(const CutFrame&) = delete;

  const Frame& frame() const { return frame_; }
  std::int32_t tet() const { return static_cast<std::int32_t>(tet_); }

 private:
  std::vector<std::array<TetId, 4>> neighbors_;
  std::size_t tet_ = 0;
  Frame frame_;
};

TEST(DrawSceneFromFrame, SurfaceEnclosesTheBody) {
  World world(small_wall());
  const Frame frame = world.frame();
  const auto picture = draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), {}, {});
  EXPECT_NEAR(enclosed_volume(picture.surface), 2 * 2 * 0.5, 1e-4);
}

/// Each edge is run along as often one way as the other.
bool is_closed(const render::Surface& surface) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> runs;
  const auto place = [&](std::size_t i) {
    return Place{surface.positions[i].x(), surface.positions[i].y(), surface.positions[i].z()};
  };
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    const Place a = place(i), b = place(i % 3 == 2 ? i - 2 : i + 1);
    runs[std::minmax(a, b)] += a < b ? 1 : -1;
  }
  return std::ranges::all_of(runs, [](const auto& edge) { return edge.second == 0; });
}

TEST(DrawSceneFromFrame, WhatIsCalledClosedIs) {
  const Scene scene = testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(0.01));
  World world(scene);
  const EmbeddedDisplay display = embedded_display(world.frame(), scene);
  for (int i = 0; i < 30; ++i) world.step();
  ASSERT_GT(world.frame().fragments, 10);
  for (const ElementStyle elements : {ElementStyle::surface, ElementStyle::shrunken}) {
    ViewSettings view;
    view.elements = elements;
    const render::DrawScene drawn = draw_scene_from_frame(world.frame(), display, scene, view, {});
    EXPECT_TRUE(drawn.surface.closed);
    EXPECT_TRUE(is_closed(drawn.surface));
  }
}

TEST(DrawSceneFromFrame, ArraysFitTogether) {
  World world(small_wall());
  const Frame frame = world.frame();
  for (const char* quantity : {"von_mises", "speed", "body"}) {
    ViewSettings view;
    view.quantity = quantity;
    const render::Surface surface =
        draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), view, {}).surface;
    const std::size_t triangles = surface.ids.size();
    EXPECT_EQ(surface.positions.size(), 3 * triangles);
    EXPECT_EQ(surface.flags.size(), triangles);
    EXPECT_EQ(surface.scalars.size() + surface.colors.size(),
              std::string(quantity) == "speed" ? 3 * triangles : triangles);
    for (const std::int32_t id : surface.ids) EXPECT_LT(static_cast<std::size_t>(id), frame.elements.tets.size());
  }
}

TEST(DrawSceneFromFrame, OnlyFacesThatWereInsideAreCracks) {
  World world(small_wall());
  const Frame start = world.frame();
  const EmbeddedDisplay display = embedded_display(start, small_wall());
  for (const std::uint8_t flags : draw_scene_from_frame(start, display, small_wall(), {}, {}).surface.flags) {
    EXPECT_FALSE(flags & render::kCrackFace);
  }
  const CutFrame cut(start);
  const render::Surface surface = draw_scene_from_frame(cut.frame(), display, small_wall(), {}, {}).surface;
  int cracks = 0;
  for (std::size_t i = 0; i < surface.flags.size(); ++i) {
    if (!(surface.flags[i] & render::kCrackFace)) continue;
    ++cracks;
    EXPECT_EQ(surface.ids[i], cut.tet());
  }
  EXPECT_EQ(cracks, 1);
}

TEST(DrawSceneFromFrame, InNaturalColorsACrackHasTheColorOfTheInside) {
  const World world(small_wall());
  const Frame start = world.frame();
  const CutFrame cut(start);
  ViewSettings view;
  view.quantity = "material";
  view.splinters = false;
  const render::Surface surface =
      draw_scene_from_frame(cut.frame(), embedded_display(start, small_wall()), small_wall(), view, {}).surface;
  const std::vector<render::EmbeddedMaterial> looks = natural_materials(small_wall());
  int inside = 0;
  for (std::size_t i = 0; i < surface.colors.size(); ++i) {
    EXPECT_FALSE(surface.flags[i] & render::kCrackFace);
    if (surface.colors[i].r != looks[look_index(0, Look::inside)].color.r) continue;
    ++inside;
    EXPECT_EQ(surface.ids[i], cut.tet());
  }
  EXPECT_EQ(inside, 1);
}

TEST(DrawSceneFromFrame, ClearMatterHasOneColorWhicheverFaceLightPasses) {
  int clear = 0;
  for (const MaterialPreset& preset : material_presets()) {
    Scene scene = small_wall();
    scene.bodies[0].material = preset.material;
    const std::vector<render::EmbeddedMaterial> looks = natural_materials(scene);
    const render::EmbeddedMaterial& outside = looks[look_index(0, Look::outside)];
    const render::EmbeddedMaterial& inside = looks[look_index(0, Look::inside)];
    EXPECT_EQ(outside.clear_depth, inside.clear_depth);
    if (outside.clear_depth == 0) continue;
    ++clear;
    EXPECT_EQ(outside.color.r, inside.color.r);
    EXPECT_EQ(outside.color.g, inside.color.g);
    EXPECT_EQ(outside.color.b, inside.color.b);
  }
  EXPECT_EQ(clear, 3);  // glass, acrylic, ice
}

TEST(DrawSceneFromFrame, SelectionAndLockedRangeAreTakenOver) {
  World world(small_wall());
  const Frame frame = world.frame();
  ViewSettings view;
  view.range = Vec2(-1, 5);
  view.color_map = "coolwarm";
  const TetId selected(0);
  const ui::Selection selection = ui::select(frame, selected, frame.elements.tets[0][0]);
  const render::Surface surface =
      draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), view, selection).surface;
  EXPECT_EQ(surface.scalar_style.minimum, -1);
  EXPECT_EQ(surface.scalar_style.maximum, 5);
  EXPECT_EQ(surface.scalar_style.color_map, render::ColorMap::coolwarm);
  for (std::size_t i = 0; i < surface.flags.size(); ++i) {
    EXPECT_EQ((surface.flags[i] & render::kSelected) != 0, surface.ids[i] == selected.index());
  }
}

TEST(DrawSceneFromFrame, ColorsOfWhatHasASignPartAtZeroUnlessOthersAreChosen) {
  World world(small_wall());
  for (int step = 0; step < 8; ++step) world.step();
  const Frame frame = world.frame();
  const auto style_of = [&](const ViewSettings& view) {
    return draw_scene_from_frame(frame, embedded_display(frame, small_wall()), small_wall(), view, {})
        .surface.scalar_style;
  };
  for (const char* quantity : {"pressure", "max_principal_stress", "mid_principal_stress", "min_principal_stress"}) {
    ViewSettings view;
    view.quantity = quantity;
    EXPECT_EQ(style_of(view).color_map, render::ColorMap::coolwarm) << quantity;
    EXPECT_EQ(style_of(view).minimum, -style_of(view).maximum) << quantity;
    const double reach = style_of(view).maximum;
    view.range = Vec2(-reach, reach);  // locked as it is
    EXPECT_EQ(style_of(view).color_map, render::ColorMap::coolwarm) << quantity;
    view.range = Vec2(0, 3e6);
    EXPECT_EQ(style_of(view).color_map, render::ColorMap::viridis) << quantity;
    view.range.reset();
    view.color_map = "cividis";
    EXPECT_EQ(style_of(view).color_map, render::ColorMap::cividis) << quantity;
    EXPECT_NE(style_of(view).minimum, -style_of(view).maximum) << quantity;
  }
  for (const char* quantity : {"von_mises", "utilization", "speed"}) {
    const bool has_limit = std::string_view(quantity) == "utilization";
    ViewSettings view;
    view.quantity = quantity;
    EXPECT_EQ(style_of(view).color_map, has_limit ? render::ColorMap::heat : render::ColorMap::viridis) << quantity;
    EXPECT_EQ(style_of(view).minimum, 0) << quantity;
  }
}

}  // namespace
}  // namespace griffith::app
