#include "app/editor/world_loader.h"

#include <gtest/gtest.h>

#include <future>

#include "app/shared/expected_mesh.h"
#include "program.h"
#include "sim/core/error.h"
#include "sim/world/setup/shape_mesh.h"

namespace griffith::app {
namespace {

constexpr double kAnyMany = 1e9;

Scene scene_of(const Shape& shape) {
  Scene scene;
  scene.bodies.emplace_back();
  scene.bodies[0].shape = shape;
  return scene;
}

/// The work goes on until the test lets it end, so a call that waited for it would never return.
TEST(WorldLoader, CancelDoesNotWaitForTheWork) {
  std::promise<void> end, begun;
  WorldLoader loader;
  const auto deaf = [&](const Monitor&) {
    begun.set_value();
    end.get_future().wait();
    return scene_of(BoxShape{});
  };
  loader.start(LoadReason::open, deaf, "", kAnyMany);
  begun.get_future().wait();
  loader.cancel();
  EXPECT_TRUE(loader.stage().empty());
  loader.start(LoadReason::follow, scene_of(SphereShape{}), "", kAnyMany);
  ASSERT_TRUE(loader.wait(60));
  EXPECT_TRUE(std::holds_alternative<SphereShape>(loader.take()->scene.bodies[0].shape)) << "not the cancelled one";
  end.set_value();
}

TEST(WorldLoader, AMeshLargerThanWantedIsMadeWhenAskedForAgain) {
  WorldLoader loader;
  loader.start(LoadReason::open, scene_of(BoxShape{}), "", 10);
  ASSERT_TRUE(loader.wait(60));
  try {
    loader.take();
    FAIL() << "it makes more than 10 tetrahedra";
  } catch (const LargeMesh& mesh) {
    EXPECT_EQ(mesh.tets, 40);
  }
  loader.start_again();
  ASSERT_TRUE(loader.wait(60));
  EXPECT_EQ(loader.take()->world.frame().elements.tets.size(), 40u);
}

TEST(WorldLoader, ASurfaceThatCannotBeReadIsReportedWithItsBody) {
  SurfaceShape surface;
  surface.path = test_folder() / "missing.off";
  surface.meshing.element_size = 0.05;
  WorldLoader loader;
  loader.start(LoadReason::open, scene_of(surface), "scene.json", kAnyMany);
  ASSERT_TRUE(loader.wait(60));
  try {
    loader.take();
    FAIL() << "there is no such file";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("scene.json#/bodies/0"), std::string::npos) << error.what();
  }
}

TEST(ExpectedTets, AreAboutAsManyAsAreMade) {
  test_file("tet.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  SurfaceShape surface;
  surface.path = test_folder() / "tet.off";
  surface.meshing.element_size = 0.05;
  surface.meshing.method = MeshingMethod::volumetric;
  BoxShape box;
  box.element_size = Vec3(0.1, 0.2, 0.05);
  box.pattern = BoxPattern::bcc;
  SphereShape sphere;
  sphere.element_size = 0.05;
  sphere.pattern = BoxPattern::kuhn;
  for (const Shape& shape : {Shape(box), Shape(CylinderShape{}), Shape(DiscShape{}), Shape(sphere),
                             Shape(PlateWithHoleShape{}), Shape(NotchedBeamShape{}), Shape(surface)}) {
    const double made = static_cast<double>(make_soup(shape, "").tets.size());
    const double expected = expected_tets(scene_of(shape));
    EXPECT_GT(expected, made / 3) << shape.index();
    EXPECT_LT(expected, made * 3) << shape.index();
  }
}

}  // namespace
}  // namespace griffith::app
