#include <gtest/gtest.h>

#include "sim/world/world.h"

namespace griffith {
namespace {

TEST(AutomaticElements, AreQuadraticWhereFewLieAcross) {
  const auto choice_of = [](const Vec3& size, const Vec3& element_size, const auto& change) {
    Scene scene;
    BodyDescription body;
    body.shape = BoxShape{size, element_size, BoxPattern::five_tet};
    body.elements = ElementOrder::automatic;
    change(body);
    scene.bodies = {body};
    const World world(scene);
    const Frame frame = world.frame();
    const ElementChoice choice = frame.element_choices[0];
    EXPECT_EQ(choice.order == ElementOrder::quadratic, !frame.edges.ends.empty());
    EXPECT_TRUE(choice.automatic);
    return choice;
  };
  const auto nothing = [](BodyDescription&) {};
  const ElementChoice pane = choice_of(Vec3(1, 1, 0.02), Vec3(0.1, 0.1, 0.02), nothing);
  EXPECT_EQ(pane.order, ElementOrder::quadratic);
  EXPECT_EQ(text_of(pane), "quadratic, since 1 element lies across its thinnest part");
  const ElementChoice two = choice_of(Vec3(1, 1, 0.1), Vec3(0.05, 0.05, 0.05), nothing);
  EXPECT_EQ(two.order, ElementOrder::quadratic);
  EXPECT_EQ(two.layers, 2);
  const ElementChoice cube = choice_of(Vec3(1, 1, 1), Vec3::Constant(0.25), nothing);
  EXPECT_EQ(text_of(cube), "linear, since 4 elements lie across its thinnest part");
  const ElementChoice remeshed =
      choice_of(Vec3(1, 1, 0.02), Vec3(0.1, 0.1, 0.02), [](BodyDescription& body) { body.remeshing = true; });
  EXPECT_EQ(remeshed.order, ElementOrder::quadratic);
  const ElementChoice steel = choice_of(Vec3(1, 1, 0.02), Vec3(0.1, 0.1, 0.02),
                                        [](BodyDescription& body) { body.material.yield_strength = 1e8; });
  EXPECT_EQ(steel.order, ElementOrder::quadratic);
  const ElementChoice block = choice_of(Vec3(0.2, 0.1, 0.06), Vec3(0.1, 0.1, 0.06), nothing);
  EXPECT_EQ(text_of(block), "linear, since its length is only 6.3 times its mean thickness");
  const ElementChoice rubber = choice_of(Vec3(1, 1, 0.02), Vec3(0.1, 0.1, 0.02), [](BodyDescription& body) {
    body.material.young_modulus = 1e6, body.material.density = 1000;
  });
  EXPECT_EQ(text_of(rubber), "linear, since waves cross its soft material at only 32 m/s");
}

}  // namespace
}  // namespace griffith
