#include <algorithm>
#include <array>
#include <cmath>

#include "tests/renderer/renderer_fixture.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr Grain kGrains[] = {Grain::stones, Grain::clay,  Grain::sand,   Grain::crystals, Grain::facets,
                             Grain::veins,  Grain::rings, Grain::bricks, Grain::cast};

const Camera kNear = {{-0.5f, 1.6f, 2.2f}, {0, 0.8f, 0}, 40};

/// A broken triangle, carried by the first of two tets or by the second, which lies in the same place.
EmbeddedSurface broken_triangle(Grain grain, std::int32_t tet = 0, bool reversed = false) {
  auto mesh = std::make_shared<EmbeddedMesh>();
  const std::array<Vector3f, 4> corners = {Vector3f(-1, 0, 0), Vector3f(1, 0, 0), Vector3f(0, 2, 0),
                                           Vector3f(0, 1, -1)};
  std::array<int, 3> order = {0, 1, 2};
  if (reversed) std::ranges::reverse(order);
  for (const int corner : order) {
    EmbeddedCorner made;
    made.rest = corners[static_cast<std::size_t>(corner)];
    made.weights[corner] = made.other_weights[corner] = 1;
    made.tet = made.part = made.piece = tet;
    made.style = EmbeddedStyle{0, -1, true}.packed();
    mesh->corners.push_back(made);
  }
  mesh->polygons = {{0, 3}};
  EmbeddedSurface surface;
  surface.mesh = mesh;
  for (int copy = 0; copy < 2; ++copy) surface.points.insert(surface.points.end(), corners.begin(), corners.end());
  surface.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  surface.carriers = {0, 1};
  surface.opened = {0};
  surface.materials.resize(1);
  surface.materials[0].grain = grain;
  surface.materials[0].grain_size = 0.2f;
  return surface;
}

DrawScene before_black(EmbeddedSurface surface) {
  DrawScene scene;
  scene.embedded = std::move(surface);
  scene.background = {{0, 0, 0}, {0, 0, 0}};
  return scene;
}

class GrainTest : public RendererFixture {
 protected:
  static Image drawn(const EmbeddedSurface& surface, Quality quality = Quality::standard) {
    return drawn_from(surface, kNear, quality);
  }
  static Image drawn_from(const EmbeddedSurface& surface, const Camera& camera, Quality quality = Quality::standard) {
    RenderOptions how = options();
    how.edges = false;
    how.quality = quality;
    renderer_->render(before_black(surface), camera, how);
    return renderer_->image();
  }
};

TEST_F(GrainTest, IsSeenFromStandardQualityOn) {
  const EmbeddedSurface plain = broken_triangle(Grain::none);
  for (const Grain grain : kGrains) {
    const EmbeddedSurface surface = broken_triangle(grain);
    EXPECT_EQ(drawn(plain, Quality::draft).rgba, drawn(surface, Quality::draft).rgba) << int(grain);
    for (const Quality quality : {Quality::standard, Quality::high})
      EXPECT_GT(off_fraction(drawn(plain, quality), drawn(surface, quality)), 0.05) << int(grain);
  }
}

/// A triangle of the same material and place at rest.
TEST_F(GrainTest, TrianglesShowItAsPolygonsDo) {
  for (const Grain grain : kGrains) {
    const EmbeddedSurface polygon = broken_triangle(grain);
    DrawScene scene = before_black({});
    scene.embedded.materials = polygon.materials;
    for (const EmbeddedCorner& corner : polygon.mesh->corners) scene.surface.positions.push_back(corner.rest);
    scene.surface.rests = scene.surface.positions;
    scene.surface.colors = {polygon.materials[0].color};
    scene.surface.matters = {0};
    RenderOptions how = options();
    how.edges = false;
    how.quality = Quality::standard;
    const Image expected = drawn(polygon);
    renderer_->render(scene, kNear, how);
    EXPECT_LT(off_fraction(renderer_->image(), expected), 0.001) << int(grain);
    scene.surface.matters = {-1};
    renderer_->render(scene, kNear, how);
    EXPECT_GT(off_fraction(renderer_->image(), expected), 0.05) << int(grain);
  }
}

TEST_F(GrainTest, NumbersAndColorsOfPiecesHaveNone) {
  for (const Grain grain : kGrains) {
    EmbeddedSurface plain = broken_triangle(Grain::none), surface = broken_triangle(grain);
    plain.scalars = surface.scalars = {0.3f, 0.8f};
    EXPECT_EQ(drawn(plain).rgba, drawn(surface).rgba) << int(grain);
    plain.scalars = surface.scalars = {};
    plain.piece_colors = surface.piece_colors = {{0.8f, 0.2f, 0.1f}, {0.1f, 0.5f, 0.9f}};
    EXPECT_EQ(drawn(plain).rgba, drawn(surface).rgba) << int(grain);
  }
}

TEST_F(GrainTest, BothSidesOfACrackShowOneColorAtOnePlace) {
  for (const Grain grain : kGrains)
    EXPECT_EQ(off_fraction(drawn(broken_triangle(grain)), drawn(broken_triangle(grain, 1, true))), 0) << int(grain);
}

/// A body and a camera that move alike give one picture; a body that stands elsewhere before anything moved another.
TEST_F(GrainTest, MovesWithTheBody) {
  const Vector3f away(0.5f, 0.25f, -1);
  for (const Grain grain : kGrains) {
    const EmbeddedSurface still = broken_triangle(grain);
    EmbeddedSurface moved = still, other = still;
    for (Vector3f& point : moved.points) point += away;
    Camera camera = kNear;
    camera.position += away;
    camera.target += away;
    EXPECT_LT(off_fraction(drawn(still), drawn_from(moved, camera)), 0.002) << int(grain);
    EmbeddedMesh elsewhere = *still.mesh;
    for (EmbeddedCorner& corner : elsewhere.corners) corner.rest += away;
    other.mesh = std::make_shared<EmbeddedMesh>(elsewhere);
    EXPECT_GT(off_fraction(drawn(still), drawn(other)), 0.05) << int(grain);
  }
}

TEST_F(GrainTest, WhatIsSmallerThanAPixelFadesAway) {
  const Image plain = drawn(broken_triangle(Grain::none));
  for (const Grain grain : kGrains) {
    EmbeddedSurface fine = broken_triangle(grain);
    fine.materials[0].grain_size = 1e-3f;
    EXPECT_EQ(off_fraction(plain, drawn(fine)), 0) << int(grain);
  }
}

/// Standard deviation over mean of green within the middle half of what is drawn of the triangle.
double contrast(const Image& image) {
  std::vector<double> values;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      bool inside = true;
      for (int i = 0; i < 9; ++i) {
        const int column = x + i % 3 - 1, row = y + i / 3 - 1;
        inside &=
            column >= 0 && row >= 0 && column < image.width && row < image.height && image.pixel(column, row)[1] > 0;
      }
      if (inside) values.push_back(image.pixel(x, y)[1]);
    }
  double mean = 0, square = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) square += (value - mean) * (value - mean) / static_cast<double>(values.size());
  return std::sqrt(square) / mean;
}

/// Faces that are seen aslant show the grain of those that are seen straight.
TEST_F(GrainTest, IsSeenOnFacesThatAreTurnedAway) {
  const auto seen_at = [](float degrees) {
    const float angle = degrees * 0.017453293f, away = 9;
    return Camera{{away * std::sin(angle), 0.8f, away * std::cos(angle)}, {0, 0.8f, 0}, 14};
  };
  EmbeddedSurface surface = broken_triangle(Grain::crystals);
  surface.materials[0].grain_size = 0.05f;
  const double straight = contrast(drawn_from(surface, seen_at(0)));
  EXPECT_GT(straight, 0.1);
  for (const float degrees : {45.0f, 60.0f, 70.0f, 75.0f})
    EXPECT_GT(contrast(drawn_from(surface, seen_at(degrees))), 0.5 * straight) << degrees;
}

/// From afar a body is about as bright as from near: the mean of a grain's colors is that of its material.
TEST_F(GrainTest, KeepsTheMeanBrightness) {
  const auto brightness = [](const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) sum += light_shown_as(image.pixel(x, y)[1]);
    return sum;
  };
  const double plain = brightness(drawn(broken_triangle(Grain::none)));
  for (const Grain grain : kGrains)
    EXPECT_NEAR(brightness(drawn(broken_triangle(grain))) / plain, 1, 0.1) << int(grain);
}

}  // namespace
}  // namespace griffith::render
