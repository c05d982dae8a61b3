#include <gtest/gtest.h>

#include "tests/elasticity/elastic_body.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::ElasticBody;

class Inversion : public ::testing::TestWithParam<ElementModel> {
 protected:
  Material material() const {
    Material m;
    m.young_modulus = 1e6;
    m.poisson_ratio = 0.3;
    m.element_model = GetParam();
    return m;
  }
};
INSTANTIATE_TEST_SUITE_P(Models, Inversion, ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TetSoup one_tet() {
  testing::RandomValues random(1);
  const Corners corners = testing::random_corners(random);
  TetSoup soup;
  for (int i = 0; i < 4; ++i) soup.points.push_back(corners.col(i));
  soup.tets = {{0, 1, 2, 3}};
  return soup;
}

/// Pushes node 0 of a body through the opposite faces of its tets and lets go: the body finds back.
void expect_recovery(ElasticBody body, const Vec3& push) {
  body.positions[0] += push;
  ASSERT_GT(body.inverted_tets(), 0);
  body.integrate(4000, 2e-4, 1, 30);
  EXPECT_EQ(body.inverted_tets(), 0);
  EXPECT_LT(body.elastic_energy(), 1e-6 * body.material.young_modulus);
}

TEST_P(Inversion, OneTetTurnsBack) {
  ElasticBody body(one_tet(), material());
  Vec3 opposite = (body.positions[1] + body.positions[2] + body.positions[3]) / 3;
  expect_recovery(body, 1.4 * (opposite - body.positions[0]));
}

TEST_P(Inversion, ACornerPushedIntoABoxComesOut) {
  const ElasticBody body(make_box(Vec3::Ones(), Vec3::Constant(0.5), BoxPattern::five_tet), material());
  expect_recovery(body, -0.9 * body.positions[0]);
}

TEST_P(Inversion, ABoxFoldedFlatUnfolds) {
  ElasticBody body(make_box(Vec3::Ones(), Vec3::Constant(0.5), BoxPattern::five_tet), material());
  testing::RandomValues random(2);
  for (Vec3& position : body.positions) position = Vec3(1, 1, 1e-3).cwiseProduct(position) + random.vector(1e-3);
  body.integrate(4000, 2e-4, 1, 30);
  EXPECT_EQ(body.inverted_tets(), 0);
}

}  // namespace
}  // namespace griffith
