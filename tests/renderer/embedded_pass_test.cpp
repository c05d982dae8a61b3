#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "renderer/egl_context.h"
#include "renderer/renderer.h"

namespace griffith::render {
namespace {

using Eigen::Vector3f;

constexpr int kWidth = 160, kHeight = 120;
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

Camera camera() {
  Camera camera;
  camera.position = {2.2f, 1.9f, 3.1f};
  camera.target = {0.5f, 0.4f, 0.3f};
  return camera;
}

const std::vector<Vector3f> kPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.1f, 1.2f, 0.9f}};
const std::vector<std::array<std::int32_t, 4>> kTets = {{0, 1, 2, 3}, {4, 2, 1, 3}};

/// The faces of two tets, each carried by its own tet or by the other one.
std::shared_ptr<const EmbeddedMesh> faces_of_tets(bool inner_second) {
  auto mesh = std::make_shared<EmbeddedMesh>();
  for (std::int32_t tet = 0; tet < 2; ++tet)
    for (int face = 0; face < 4; ++face) {
      const bool outer = tet == 0 || !inner_second;
      if (outer) mesh->outer.push_back(static_cast<std::int32_t>(mesh->polygons.size()));
      mesh->polygons.push_back({static_cast<std::int32_t>(mesh->corners.size()), 3});
      for (const int corner : kFaces[static_cast<std::size_t>(face)]) {
        EmbeddedCorner made;
        made.weights[corner] = 1;
        made.other_weights[corner] = 1;
        made.tet = made.part = made.piece = tet;
        made.style = EmbeddedStyle{0, face, false}.packed();
        mesh->corners.push_back(made);
      }
    }
  return mesh;
}

EmbeddedSurface embedded(bool inner_second = false) {
  EmbeddedSurface surface;
  surface.mesh = faces_of_tets(inner_second);
  surface.points = kPoints;
  surface.tets = kTets;
  surface.carriers = {0, 1};
  surface.piece_colors = {{0.8f, 0.2f, 0.1f}, {0.1f, 0.5f, 0.9f}};
  surface.materials.resize(1);
  return surface;
}

/// The same faces as plain triangles.
Surface triangles(const EmbeddedSurface& like) {
  Surface surface;
  for (std::size_t tet = 0; tet < 2; ++tet)
    for (const auto& face : kFaces) {
      for (const int corner : face) {
        const int point = kTets[tet][static_cast<std::size_t>(corner)];
        surface.positions.push_back(kPoints[static_cast<std::size_t>(point)]);
        if (like.scalars_per_point) surface.scalars.push_back(like.scalars[static_cast<std::size_t>(point)]);
      }
      if (!like.scalars.empty() && !like.scalars_per_point) surface.scalars.push_back(like.scalars[tet]);
      if (like.scalars.empty()) surface.colors.push_back(like.piece_colors[tet]);
      surface.ids.push_back(static_cast<std::int32_t>(tet));
      const bool selected = like.selected_tet == static_cast<std::int32_t>(tet);
      surface.flags.push_back(static_cast<std::uint8_t>(kAllEdges | (selected ? kSelected : 0)));
    }
  return surface;
}

class EmbeddedPassTest : public ::testing::Test {
 protected:
  Image picture(const DrawScene& scene, Quality quality = RenderOptions().quality, bool edges = true) {
    RenderOptions options;
    options.quality = quality;
    options.edges = edges;
    options.width = kWidth;
    options.height = kHeight;
    renderer_.render(scene, camera(), options);
    return renderer_.image();
  }
  Image picture(const EmbeddedSurface& surface, Quality quality = RenderOptions().quality, bool edges = true) {
    DrawScene scene;
    scene.embedded = surface;
    scene.ground = Ground{-0.5f};
    return picture(scene, quality, edges);
  }
  Image picture(const Surface& surface) {
    DrawScene scene;
    scene.surface = surface;
    scene.ground = Ground{-0.5f};
    return picture(scene);
  }

  const EglContext context_{std::nullopt};
  Renderer renderer_;
};

int different_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) count += a.pixel(x, y) != b.pixel(x, y);
  return count;
}

TEST_F(EmbeddedPassTest, LooksLikeTheTrianglesThatItStandsFor) {
  EmbeddedSurface surface = embedded();
  EXPECT_LE(different_pixels(picture(surface), picture(triangles(surface))), 2);
  surface.selected_tet = 1;
  EXPECT_LE(different_pixels(picture(surface), picture(triangles(surface))), 2);
  surface.scalars = {0.2f, 0.7f};
  EXPECT_LE(different_pixels(picture(surface), picture(triangles(surface))), 2);
  surface.scalars = {0, 0.3f, 0.5f, 0.8f, 1};
  surface.scalars_per_point = true;
  EXPECT_LE(different_pixels(picture(surface), picture(triangles(surface))), 20);  // steps of the table
}

TEST_F(EmbeddedPassTest, IdsAreTets) {
  picture(embedded());
  bool seen[2] = {};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (const int id = renderer_.id_at(x, y); id >= 0) seen[id] = true;
  EXPECT_TRUE(seen[1]);
}

TEST_F(EmbeddedPassTest, WhatIsClosedIsNotDrawnUntilItOpens) {
  EmbeddedSurface surface = embedded(true);
  const Image closed = picture(surface);
  surface.opened = {4, 5, 6, 7};
  const Image open = picture(surface);
  EXPECT_GT(different_pixels(closed, open), 500);
  EXPECT_EQ(different_pixels(open, picture(embedded())), 0);
  surface.opened.clear();
  EXPECT_EQ(different_pixels(closed, picture(surface)), 0);
}

TEST_F(EmbeddedPassTest, AnotherCarrierMovesAPart) {
  EmbeddedSurface surface = embedded();
  surface.carriers = {0, 0};  // with the same weights, so the second tet comes to lie on the first
  const Image moved = picture(surface);
  EXPECT_EQ(different_pixels(moved, picture(embedded(true))), 0);
  EXPECT_GT(different_pixels(moved, picture(embedded())), 500);
}

TEST_F(EmbeddedPassTest, InnerFacesShowTheirMaterialAndFromStandardQualityOnItsNoise) {
  EmbeddedSurface surface = embedded();
  surface.piece_colors.clear();
  EmbeddedSurface rough = surface, green = surface;
  rough.materials[0].roughness = 0.5f;
  green.materials[0].color = {0.2f, 0.4f, 0.1f};
  for (const Quality quality : {Quality::draft, Quality::standard, Quality::high}) {
    const Image even = picture(surface, quality);
    EXPECT_GT(different_pixels(even, picture(green, quality)), 500);
    EXPECT_EQ(different_pixels(even, picture(rough, quality)) > 500, quality != Quality::draft);
  }
}

TEST_F(EmbeddedPassTest, GlazeAddsWhatItMirrorsFromStandardQualityOn) {
  EmbeddedSurface dull = embedded();
  dull.piece_colors.clear();
  EmbeddedSurface glazed = dull;
  glazed.materials[0].gloss = 1;
  EXPECT_EQ(picture(dull, Quality::draft), picture(glazed, Quality::draft));
  for (const Quality quality : {Quality::standard, Quality::high}) {
    const Image without = picture(dull, quality), with = picture(glazed, quality);
    EXPECT_GT(different_pixels(without, with), 500);
    for (std::size_t i = 0; i < with.rgba.size(); ++i) ASSERT_GE(with.rgba[i], without.rgba[i]);
  }
}

/// Without edges a draft of materials has a shader of its own.
TEST_F(EmbeddedPassTest, EdgesThatAreNotThereChangeNothing) {
  EmbeddedSurface surface = embedded();
  surface.piece_colors.clear();
  surface.materials[0].variation = 0.5f;
  EmbeddedMesh mesh = *surface.mesh;
  for (EmbeddedCorner& corner : mesh.corners) corner.style = EmbeddedStyle{0, -1, true}.packed();
  surface.mesh = std::make_shared<EmbeddedMesh>(mesh);
  for (const std::int32_t selected : {-1, 1}) {
    surface.selected_tet = selected;
    for (const Quality quality : {Quality::draft, Quality::standard})
      EXPECT_EQ(picture(surface, quality, true), picture(surface, quality, false));
  }
}

/// Body, shadow and what is seen through it.
TEST_F(EmbeddedPassTest, AMaterialLooksTheSameWhereverItStandsInTheList) {
  DrawScene first;
  first.ground = Ground{-0.5f};
  first.embedded = embedded();
  first.embedded.piece_colors.clear();
  EmbeddedMaterial material, other;
  material.color = {0.5f, 0.8f, 0.7f};
  material.fiber = {0.3f, 0.2f, 0.1f};
  DrawScene third = first;
  EmbeddedMesh mesh = *first.embedded.mesh;
  for (EmbeddedCorner& corner : mesh.corners) corner.style += EmbeddedStyle{2}.packed();
  third.embedded.mesh = std::make_shared<EmbeddedMesh>(mesh);
  for (const float clear_depth : {0.0f, 0.5f}) {
    material.clear_depth = clear_depth;
    other.clear_depth = 0.5f - clear_depth;
    first.embedded.materials = {material, other, other};
    third.embedded.materials = {other, other, material};
    EXPECT_EQ(different_pixels(picture(first, Quality::standard), picture(third, Quality::standard)), 0) << clear_depth;
  }
}

/// Without a selection vertices omit what a pass does not draw, with one fragments do.
TEST_F(EmbeddedPassTest, ASelectionThatIsNotThereChangesNothingBesideGlass) {
  DrawScene scene;
  scene.ground = Ground{-0.5f};
  scene.embedded = embedded();
  scene.embedded.piece_colors.clear();
  EmbeddedMesh mesh = *scene.embedded.mesh;
  for (EmbeddedCorner& corner : mesh.corners) corner.style += EmbeddedStyle{corner.tet}.packed();
  scene.embedded.mesh = std::make_shared<EmbeddedMesh>(mesh);
  EmbeddedMaterial glass, stone;
  glass.clear_depth = 0.5f;
  for (const auto& materials : {std::vector{glass, stone}, {stone, glass}, {glass, glass}, {stone, stone}}) {
    scene.embedded.materials = materials;
    scene.embedded.selected_tet = -1;
    const Image none = picture(scene, Quality::standard);
    scene.embedded.selected_tet = 7;
    EXPECT_EQ(different_pixels(none, picture(scene, Quality::standard)), 0);
    scene.embedded.selected_tet = 1;
    EXPECT_GT(different_pixels(none, picture(scene, Quality::standard)), 100);
  }
}

/// Gives every corner its face's normal as it was before the tets were deformed: `before` moved the points to where
/// they are now.
EmbeddedSurface with_normals(const Eigen::Matrix3f& before) {
  EmbeddedSurface surface = embedded();
  EmbeddedMesh mesh = *surface.mesh;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const auto& tet = kTets[static_cast<std::size_t>(mesh.corners[i].tet)];
    const auto rest = [&](int corner) -> Vector3f { return before * kPoints[static_cast<std::size_t>(tet[corner])]; };
    const auto& face = kFaces[i / 3 % 4];
    const Vector3f normal = (rest(face[1]) - rest(face[0])).cross(rest(face[2]) - rest(face[0]));
    const Vector3f products(normal.dot(rest(1) - rest(0)), normal.dot(rest(2) - rest(0)),
                            normal.dot(rest(3) - rest(0)));
    for (std::size_t k = 0; k < 3; ++k)
      mesh.corners[i + k].normal = mesh.corners[i + k].other_normal = CarriedNormal(products);
  }
  surface.mesh = std::make_shared<EmbeddedMesh>(std::move(mesh));
  return surface;
}

/// A normal that a tet carries stays normal to what it was normal to, whatever the deformation: so the picture is that
/// of flat faces.
TEST_F(EmbeddedPassTest, CarriedNormalsMoveAsPlanesDo) {
  const Image flat = picture(embedded());
  Eigen::Matrix3f sheared, turned;
  sheared << 1, 0.8f, 0.1f, -0.3f, 1.4f, 0, 0.2f, 0.5f, 0.6f;
  turned << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const Eigen::Matrix3f& before : {Eigen::Matrix3f(Eigen::Matrix3f::Identity()), sheared, turned}) {
    const Image smooth = picture(with_normals(before));
    int far_off = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c)
          far_off += std::abs(int(flat.pixel(x, y)[std::size_t(c)]) - int(smooth.pixel(x, y)[std::size_t(c)])) > 2;
    EXPECT_EQ(far_off, 0);
  }
}

TEST_F(EmbeddedPassTest, ANormalTiltsTheLight) {
  EmbeddedSurface surface = embedded();
  EmbeddedMesh mesh = *surface.mesh;
  for (EmbeddedCorner& corner : mesh.corners) corner.normal = CarriedNormal(Vector3f(1, 2, 3));
  surface.mesh = std::make_shared<EmbeddedMesh>(std::move(mesh));
  EXPECT_GT(different_pixels(picture(embedded()), picture(surface)), 500);
}

TEST_F(EmbeddedPassTest, TheCheckerShowsOnTexturedPolygonsAlone) {
  EmbeddedSurface surface = embedded();
  const Image plain = picture(surface);
  surface.checker = true;
  EXPECT_EQ(different_pixels(plain, picture(surface)), 0);
  EmbeddedMesh mesh = *surface.mesh;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    mesh.corners[i].style = EmbeddedStyle{0, -1, false, true}.packed();
    mesh.corners[i].uv = Eigen::Vector2f(i % 3 == 1 ? 0.25f : 0, i % 3 == 2 ? 0.25f : 0);
  }
  surface.mesh = std::make_shared<EmbeddedMesh>(std::move(mesh));
  const Image checked = picture(surface);
  surface.checker = false;
  EXPECT_GT(different_pixels(checked, picture(surface)), 500);
}

/// Walls that open one after the other look as if all had been there from the start.
TEST_F(EmbeddedPassTest, OpeningInStepsIsOpeningAtOnce) {
  EmbeddedSurface surface = embedded(true);
  for (const std::int32_t polygon : {6, 4, 7, 5}) {
    surface.opened.push_back(polygon);
    picture(surface);
  }
  EXPECT_EQ(different_pixels(picture(surface), picture(embedded())), 0);
}

}  // namespace
}  // namespace griffith::render
