#include "renderer/hidden_backs.h"

#include <algorithm>
#include <array>

#include "tests/renderer/renderer_fixture.h"
#include "tests/renderer/wall_scene.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr Quality kQualities[] = {Quality::draft, Quality::standard, Quality::high};

class HiddenBacksTest : public RendererFixture {
 protected:
  /// Returns the ids of a picture from there.
  static IdImage ids(const DrawScene& scene, const Camera& from, Quality quality) {
    RenderOptions how = options();
    how.quality = quality;
    renderer_->render(scene, from, how);
    return renderer_->ids();
  }
};

/// The triangles of an octahedron about the origin whose corners lie on the axes; along these no corner is in general
/// position.
Surface octahedron(float radius) {
  Surface surface;
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [octant](int axis) { return octant >> axis & 1 ? -1.0f : 1.0f; };
    const auto corner = [&](int axis) { return Vector3f(radius * sign(axis) * Vector3f::Unit(axis)); };
    const bool turned = sign(0) * sign(1) * sign(2) < 0;
    surface.positions.insert(surface.positions.end(), {corner(0), corner(turned ? 2 : 1), corner(turned ? 1 : 2)});
    surface.ids.push_back(octant);
  }
  surface.closed = true;
  return surface;
}

/// A tet about the origin that carries its own faces.
EmbeddedSurface embedded_tet(float radius) {
  constexpr std::array<std::array<int, 3>, 4> kTetFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  auto mesh = std::make_shared<EmbeddedMesh>();
  for (int face = 0; face < 4; ++face) {
    mesh->outer.push_back(face);
    mesh->polygons.push_back({3 * face, 3});
    for (const int corner : kTetFaces[static_cast<std::size_t>(face)]) {
      EmbeddedCorner made;
      made.weights[corner] = made.other_weights[corner] = 1;
      mesh->corners.push_back(made);
    }
  }
  EmbeddedSurface surface;
  surface.mesh = std::move(mesh);
  for (const Vector3f& corner : {Vector3f(-1, -1, -1), Vector3f(1, 1, -1), Vector3f(-1, 1, 1), Vector3f(1, -1, 1)})
    surface.points.push_back(radius * corner);
  surface.tets = {{0, 1, 2, 3}};
  surface.carriers = {0};
  surface.materials.resize(1);
  surface.closed = true;
  return surface;
}

TEST_F(HiddenBacksTest, APlaceIsInsideWhatBoundsIt) {
  const Surface surface = octahedron(2);
  for (const Vector3f& place : {Vector3f(0, 0, 0), Vector3f(0, -1.9f, 0), Vector3f(0.6f, 0.6f, 0.6f),
                                Vector3f(-1, 0, 0), Vector3f(0, 0.5f, -1)})
    EXPECT_TRUE(is_inside(surface, place)) << place.transpose();
  for (const Vector3f& place : {Vector3f(0, -3, 0), Vector3f(0, 2.1f, 0), Vector3f(0.7f, 0.7f, 0.7f),
                                Vector3f(-1, -1.1f, 0), Vector3f(2.5f, 0, 0), Vector3f(1, -5, 0)})
    EXPECT_FALSE(is_inside(surface, place)) << place.transpose();
}

TEST_F(HiddenBacksTest, APlaceIsInsideTheTetThatHoldsIt) {
  const EmbeddedSurface surface = embedded_tet(1);
  EXPECT_TRUE(is_inside(surface, Vector3f(0, 0, 0)));
  EXPECT_TRUE(is_inside(surface, Vector3f(-0.9f, -0.95f, -0.9f)));
  EXPECT_FALSE(is_inside(surface, Vector3f(0.9f, 0.9f, 0.9f)));
  EXPECT_FALSE(is_inside(surface, Vector3f(0, 0, 1.1f)));
}

TEST_F(HiddenBacksTest, WithoutThemTheSamePixelsAreCovered) {
  DrawScene scene = wall_scene();
  DrawScene open = scene;
  open.surface.closed = false;
  for (const Quality quality : kQualities) {
    const IdImage closed_ids = ids(scene, camera(), quality), all_ids = ids(open, camera(), quality);
    int other = 0;
    for (std::size_t i = 0; i < all_ids.ids.size(); ++i) {
      EXPECT_EQ(closed_ids.ids[i] == kNoId, all_ids.ids[i] == kNoId);
      other += closed_ids.ids[i] != all_ids.ids[i];
    }
    EXPECT_LT(other, 1e-3 * kWidth * kHeight);  // faces edge-on, where two are equally near
  }
}

TEST_F(HiddenBacksTest, OpenSurfacesAreSeenFromBehind) {
  DrawScene scene;
  scene.surface.positions = filling_square(camera());
  std::swap(scene.surface.positions[1], scene.surface.positions[2]);
  std::swap(scene.surface.positions[4], scene.surface.positions[5]);
  scene.surface.ids = {0, 1};
  for (const Quality quality : kQualities) {
    const IdImage seen = ids(scene, camera(), quality);
    EXPECT_EQ(std::ranges::count(seen.ids, kNoId), 0);
  }
}

TEST_F(HiddenBacksTest, FromWithinABodyItsWallsAreSeen) {
  DrawScene surface, embedded;
  surface.surface = octahedron(2);
  embedded.embedded = embedded_tet(2);
  const Camera within = {{0, 0.1f, 0.2f}, {0.3f, 0, -1}, 60}, outside = {{0, 1, 9}, {0, 0, 0}, 60};
  for (const DrawScene& scene : {surface, embedded})
    for (const Quality quality : kQualities) {
      const IdImage seen = ids(scene, within, quality);
      EXPECT_EQ(std::ranges::count(seen.ids, kNoId), 0);
      EXPECT_GT(std::ranges::count(ids(scene, outside, quality).ids, kNoId), 0);
    }
}

TEST_F(HiddenBacksTest, WhatASliceLaysBareIsSeen) {
  DrawScene scene;
  scene.surface = octahedron(2);
  scene.visible = HalfSpace{Vector3f::UnitZ(), 0.5f};
  const Camera before = {{0, 0, 9}, {0, 0, 0}, 6};  // sees the cut alone
  for (const Quality quality : kQualities) EXPECT_EQ(std::ranges::count(ids(scene, before, quality).ids, kNoId), 0);
}

TEST_F(HiddenBacksTest, ASelectionWithinGlassIsSeenFromBehind) {
  DrawScene scene;
  scene.surface = octahedron(2);
  scene.surface.flags.assign(scene.surface.ids.size(), kClear);
  scene.surface.flags[4] = kClear | kSelected;  // the octant away from the camera
  scene.surface.clear_depth = 10;
  scene.embedded.selected_tet = 4;
  RenderOptions how = options();
  how.edges = false;
  how.quality = Quality::standard;
  const Camera from = {{0.01f, 0.01f, 9}, {0, 0, 0}, 40};
  const auto middle = [&] {
    renderer_->render(scene, from, how);
    return renderer_->image().pixel(kWidth / 2 + 16, kHeight / 2 - 16);
  };
  const auto with = middle();
  scene.surface.flags[4] = kClear;
  const auto without = middle();
  EXPECT_GT(with[0] - with[2], without[0] - without[2] + 30) << "orange shines through";
}

/// The lamp's map ends between a roof and the floor that the camera looks at.
TEST_F(HiddenBacksTest, WhatIsOutOfSightTowardTheLampCastsItsShadow) {
  const Vector3f to_lamp = Vector3f(-0.55f, 0.78f, 0.55f).normalized();
  const auto brightness = [&](bool roof) {
    DrawScene scene;
    scene.surface = octahedron(0.3f);
    for (Vector3f& corner : scene.surface.positions) corner += roof ? Vector3f(14 * to_lamp) : Vector3f(30, 0, 0);
    scene.ground = Ground{0};
    RenderOptions how = options();
    how.quality = Quality::draft;
    renderer_->render(scene, {{0.01f, 4, 0}, {0, 0, 0}, 4}, how);
    int sum = 0;
    const Image image = renderer_->image();
    for (int y = 0; y < kHeight; y += 5)
      for (int x = 0; x < kWidth; x += 5) sum += image.pixel(x, y)[1];
    return sum;
  };
  EXPECT_LT(brightness(true), 0.9 * brightness(false));
}

}  // namespace
}  // namespace griffith::render
