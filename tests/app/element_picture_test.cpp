#include "app/picture/element_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/scene_legend.h"
#include "enclosed_volume.h"
#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

Vec3 corner(const render::Surface& surface, std::size_t triangle, std::size_t i) {
  return surface.positions[3 * triangle + i].cast<double>();
}

double area(const render::Surface& surface) {
  double sum = 0;
  for (std::size_t i = 0; i < surface.ids.size(); ++i) {
    const Vec3 a = corner(surface, i, 0);
    sum += (corner(surface, i, 1) - a).cross(corner(surface, i, 2) - a).norm() / 2;
  }
  return sum;
}

/// The wall is 2 m wide, 2 m high and 0.5 m thick, its middle at (0, 1, 0).
TEST(ElementPicture, CapsFillTheCrossSectionWhateverThePlane) {
  World world(small_wall());
  const Frame frame = world.frame();
  ViewSettings view;
  const auto cap_area = [&](const Vec3& normal, double offset) {
    view.slice = SlicePlane{normal, offset};
    const ShownMesh shown = shown_mesh(frame, view, {});
    return area(surface_of(cap_triangles(shown), shown, 1, {}));
  };
  for (const double offset : {-0.2, -0.07, 0.0, 0.1}) EXPECT_NEAR(cap_area(Vec3(0, 0, 3), offset), 4, 1e-4);
  for (const double offset : {0.3, 0.61, 1.7}) EXPECT_NEAR(cap_area(Vec3(0, 1, 0), offset), 1, 1e-4);
  EXPECT_EQ(cap_area(Vec3(0, 1, 0), 2.5), 0);
  // Turned by 45° about the vertical, through the middle: as wide as the wall is thick, times √2.
  EXPECT_NEAR(cap_area(Vec3(1, 0, 1), 0), 2 * 0.5 * std::sqrt(2.0), 1e-4);
}

TEST(ElementPicture, CapsLieInThePlaneFaceWhatIsHiddenAndShowTheirTets) {
  World world(small_wall());
  const Frame frame = world.frame();
  std::mt19937 random(3);
  std::normal_distribution<double> normal_distribution;
  for (int trial = 0; trial < 50; ++trial) {
    ViewSettings view;
    const Vec3 direction(normal_distribution(random), normal_distribution(random), normal_distribution(random));
    view.slice = SlicePlane{direction, direction.normalized().dot(Vec3(0, 1, 0)) + 0.2 * normal_distribution(random)};
    const ShownMesh shown = shown_mesh(frame, view, {});
    const render::Surface caps = surface_of(cap_triangles(shown), shown, 1, {});
    for (std::size_t i = 0; i < caps.ids.size(); ++i) {
      const Vec3 a = corner(caps, i, 0), across = (corner(caps, i, 1) - a).cross(corner(caps, i, 2) - a);
      EXPECT_GE(across.dot(direction.normalized()), -1e-6);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(corner(caps, i, k).dot(direction.normalized()), view.slice->offset, 1e-6);
      EXPECT_FALSE(caps.flags[i] & render::kCrackFace);
    }
  }
}

TEST(ElementPicture, CapValuesAreInterpolatedBetweenNodes) {
  World world(small_wall());
  const Frame frame = world.frame();
  ViewSettings view;
  view.slice = SlicePlane{Vec3(1, 2, 3), 1.1};
  const ShownMesh shown = shown_mesh(frame, view, {});
  const std::vector<PictureTriangle> caps = cap_triangles(shown);
  ASSERT_FALSE(caps.empty());
  // A linear field is interpolated exactly.
  QuantityValues values;
  values.place = ValuePlace::node;
  const Vec3 gradient(0.3, -2, 0.7);
  for (const Vec3& position : frame.nodes.positions)
    values.values.push_back(static_cast<float>(gradient.dot(position)));
  render::Surface surface = surface_of(caps, shown, 1, {});
  add_scalars(caps, frame, values, surface);
  ASSERT_EQ(surface.scalars.size(), surface.positions.size());
  for (std::size_t i = 0; i < surface.scalars.size(); ++i)
    EXPECT_NEAR(surface.scalars[i], gradient.dot(surface.positions[i].cast<double>()), 1e-5);
}

TEST(ElementPicture, ShrunkenElementsKeepTheirShapeAndShareOfTheVolume) {
  World world(small_wall());
  const Frame frame = world.frame();
  const ViewSettings view;
  const ShownMesh shown = shown_mesh(frame, view, {});
  const std::vector<PictureTriangle> triangles = element_triangles(shown);
  EXPECT_EQ(triangles.size(), 4 * frame.elements.tets.size());
  for (const double shrink : {1.0, 0.75, 0.2})
    EXPECT_NEAR(enclosed_volume(surface_of(triangles, shown, shrink, {})), 2 * std::pow(shrink, 3), 1e-4);
}

TEST(ElementPicture, WireframeHasEveryEdgeOnce) {
  World world(small_wall());
  const Frame frame = world.frame();
  std::set<std::pair<int, int>> edges;
  for (const auto& tet : frame.elements.tets)
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) edges.insert(std::minmax(tet[a].index(), tet[b].index()));
  const ViewSettings view;
  const ShownMesh shown = shown_mesh(frame, view, {});
  EXPECT_EQ(wireframe(shown, nullptr, {}).size(), edges.size());
}

TEST(ElementPicture, ExplodedPiecesMoveApartAndKeepTheirShape) {
  Scene scene = small_wall();
  scene.bodies[0].material.tensile_strength *= 0.2;
  scene.bodies[0].material.fracture_toughness *= 0.2;
  World world(scene);
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.bodies.size(), 2u);
  ViewSettings view;
  view.explode = 1.5;
  const ShownMesh shown = shown_mesh(frame, view, {});
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    const Vec3 offset = shown.offsets[frame.elements.bodies[tet]];
    for (NodeId node : frame.elements.tets[tet])
      EXPECT_LT((shown.positions[node] - frame.nodes.positions[node] - offset).norm(), 1e-12);
  }
  for (const BodyView& a : frame.bodies)
    for (const BodyView& b : frame.bodies) {
      const Vec3 apart = a.center_of_mass - b.center_of_mass;
      EXPECT_LT((shown.offsets[a.id] - shown.offsets[b.id] - 1.5 * apart).norm(), 1e-12);
    }
}

TEST(ElementPicture, ColorsOfStressAndLoadTellRigidPiecesFromUnloadedOnes) {
  const Scene scene = small_wall();
  World world(scene);
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  const auto is_rigid = [](const BodyView& body) { return body.rigid; };
  ASSERT_TRUE(std::ranges::any_of(frame.bodies, is_rigid) && !std::ranges::all_of(frame.bodies, is_rigid));
  for (const char* quantity : {"von_mises", "pressure", "strain_energy", "utilization", "separation_eigenvalue",
                               "speed", "displacement", "element_quality"}) {
    ViewSettings view;
    view.quantity = quantity;
    const bool strained = std::string_view(quantity) != "speed" && std::string_view(quantity) != "displacement" &&
                          std::string_view(quantity) != "element_quality";
    const render::DrawScene drawn = draw_scene_from_frame(frame, embedded_display(frame, scene), scene, view, {});
    for (std::size_t i = 0; i < drawn.surface.ids.size(); ++i) {
      const bool rigid = frame.bodies[frame.elements.bodies[TetId(drawn.surface.ids[i])]].rigid;
      EXPECT_EQ((drawn.surface.flags[i] & render::kPlain) != 0, rigid && strained) << quantity;
    }
    const std::optional<ui::Legend> legend = scene_legend(drawn, false);
    ASSERT_TRUE(legend);
    EXPECT_EQ(legend->samples.size(), strained ? 1u : 0u) << quantity;
    if (strained) {
      EXPECT_EQ(legend->samples[0].meaning, "rigid");
    }
  }
}

TEST(ElementPicture, OnlyCrackFacesHaveAnAge) {
  Scene scene = small_wall();
  scene.bodies[0].material.tensile_strength *= 0.2;
  World world(scene);
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  ViewSettings view;
  view.quantity = "crack_age";
  const render::Surface surface = draw_scene_from_frame(frame, embedded_display(frame, scene), scene, view, {}).surface;
  int cracks = 0;
  for (std::size_t i = 0; i < surface.ids.size(); ++i) {
    const bool crack = surface.flags[i] & render::kCrackFace;
    EXPECT_NE(crack, (surface.flags[i] & render::kPlain) != 0);
    EXPECT_NE(crack, std::isnan(surface.scalars[i]));
    EXPECT_TRUE(!crack || (surface.scalars[i] >= 0 && surface.scalars[i] <= frame.time));
    cracks += crack;
  }
  EXPECT_GT(cracks, 10);
}

}  // namespace
}  // namespace griffith::app
