#include "sim/mesh/mesh_layers.h"

#include <gtest/gtest.h>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"

namespace griffith {
namespace {

int layers_of(const Vec3& size, const Vec3& element_size, BoxPattern pattern) {
  return layers_across(build_mesh(make_box(size, element_size, pattern)));
}

constexpr BoxPattern kCubePatterns[] = {BoxPattern::five_tet, BoxPattern::kuhn};

TEST(LayersAcross, CountsThoseOfAPlateOfAnyAspect) {
  for (const BoxPattern pattern : kCubePatterns)
    for (const double aspect : {1.0, 4.0, 16.0})
      for (const int layers : {1, 2, 3, 4, 5, 6}) {
        const double width = 16 * aspect * 0.01;
        EXPECT_EQ(layers_of(Vec3(width, width, 0.01 * layers), Vec3(aspect * 0.01, aspect * 0.01, 0.01), pattern),
                  layers)
            << aspect;
      }
}

TEST(LayersAcross, CountsThoseOfCubesAndBars) {
  for (const BoxPattern pattern : kCubePatterns)
    for (const int layers : {1, 2, 4}) {
      EXPECT_EQ(layers_of(Vec3::Constant(layers), Vec3::Ones(), pattern), layers);
      EXPECT_EQ(layers_of(Vec3(20, layers, layers), Vec3::Ones(), pattern), layers);
    }
}

TEST(LayersAcross, AThinPartCounts) {
  // A block of six layers, and a plate of one with a quarter of the volume.
  TetSoup soup = make_box(Vec3(6, 6, 6), Vec3::Ones(), BoxPattern::kuhn);
  const TetSoup flange = make_box(Vec3(12, 6, 1), Vec3::Ones(), BoxPattern::kuhn);
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& point : flange.points) soup.points.push_back(point + Vec3(20, 0, 0));
  for (const std::array<int, 4>& tet : flange.tets)
    soup.tets.push_back({tet[0] + first, tet[1] + first, tet[2] + first, tet[3] + first});
  EXPECT_EQ(layers_across(build_mesh(soup)), 1);
}

TEST(Slenderness, IsTheLengthOverTheMeanThickness) {
  for (const BoxPattern pattern : kCubePatterns) {
    EXPECT_NEAR(slenderness(build_mesh(make_box(Vec3::Ones(), Vec3::Ones() / 3, pattern))), 3, 1e-12);
    const double plate = slenderness(build_mesh(make_box(Vec3(1, 1, 0.01), Vec3(0.25, 0.25, 0.01), pattern)));
    EXPECT_NEAR(plate, 1 / 0.01 + 2, 1e-9);  // with its narrow sides
  }
  EXPECT_EQ(slenderness(TetMesh{}), 0);
}

TEST(LayersAcross, NoTetsHaveNone) { EXPECT_EQ(layers_across(TetMesh{}), 0); }

}  // namespace
}  // namespace griffith
