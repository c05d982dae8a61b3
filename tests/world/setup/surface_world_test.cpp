#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

#include "sim/core/error.h"
#include "sim/mesh/topology.h"
#include "sim/world/world.h"
#include "tests/meshing/surfaces.h"

namespace griffith {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Property;
using namespace griffith::testing;

/// Surfaces in a folder of the test's own, with a cache of its own.
struct SurfaceWorld : ::testing::Test {
  SurfaceWorld() {
    folder = test_folder();
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
  }

  /// A weak body of the surface, about 1 m in size, that a fast ball is about to strike from +z.
  Scene shot(const TriangleSurface& surface, double element_size) {
    write_off(surface, folder / "surface.off");
    return shot(folder / "surface.off", element_size);
  }
  Scene shot(const std::filesystem::path& path, double element_size) {
    SurfaceShape shape;
    shape.path = path;
    shape.meshing.element_size = element_size;
    shape.meshing.method = method;
    Scene scene;
    scene.gravity.setZero();
    scene.ground.reset();
    scene.bodies.resize(1);
    scene.bodies[0].shape = shape;
    scene.bodies[0].material.tensile_strength = 2e4;
    scene.bodies[0].material.fracture_toughness = 2e4;
    ProjectileBurst ball;
    ball.position = Vec3(0.1, 0.05, 1.2);
    ball.speed = 60;
    ball.mass = 50;
    scene.projectiles = {ball};
    return scene;
  }

  /// Steps until pieces fly; whatever comes off, no mass is lost.
  static void expect_to_break(const Scene& scene) {
    World world(scene);
    const auto mass_of = [](const Frame& frame) {
      return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
    };
    const double mass = mass_of(world.frame());
    EXPECT_GT(mass, 0);
    for (int step = 0; step < 10; ++step) world.step();
    EXPECT_GT(world.frame().fragments, 0);
    EXPECT_NEAR(mass_of(world.frame()), mass, 1e-9 * mass);
    EXPECT_EQ(world.frame().report.non_finite_values, 0);
  }

  std::filesystem::path folder;
  MeshingMethod method = MeshingMethod::automatic;
};

TEST_F(SurfaceWorld, ATorusBreaks) { expect_to_break(shot(torus_surface(0.4, 0.15, 12, 6), 0.3)); }

TEST_F(SurfaceWorld, AThinPaneBreaks) {
  expect_to_break(shot(box_surface(Vec3(-0.5, -0.5, -0.03), Vec3(0.5, 0.5, 0.03)), 0.25));
}

TEST_F(SurfaceWorld, AnOpenSurfaceBreaks) {
  TriangleSurface open = box_surface(Vec3::Constant(-0.4), Vec3::Constant(0.4));
  open.triangles.pop_back();
  expect_to_break(shot(open, 0.25));
}

TEST_F(SurfaceWorld, ASurfaceThatPassesThroughItselfBreaks) {
  const TriangleSurface cross = together(box_surface(Vec3(-0.5, -0.2, -0.2), Vec3(0.5, 0.2, 0.2)),
                                         box_surface(Vec3(-0.21, -0.5, -0.21), Vec3(0.21, 0.5, 0.21)));
  const Scene scene = shot(cross, 0.2);
  const World world(scene);
  EXPECT_THAT(world.findings(), Contains(Property(&InputError::problem, HasSubstr("passes through itself"))));
  EXPECT_THAT(world.findings(), Contains(Property(&InputError::where, "#/bodies/0/shape/surface")));
  expect_to_break(scene);
}

TEST_F(SurfaceWorld, ABearBreaks) {
  method = MeshingMethod::volumetric;
  const auto path = shipped_surface("bear.obj");
  Scene scene = shot(path, 0.3);
  scene.bodies[0].position = -bounds(read_surface(path)).center();
  scene.projectiles[0].position = Vec3(0, 0, 1.4);
  expect_to_break(scene);
}

TEST_F(SurfaceWorld, ErrorsNameTheBodyAndTheFile) {
  try {
    TriangleSurface sheet = box_surface(Vec3::Zero(), Vec3::Ones());
    sheet.triangles.resize(2);
    const World world(shot(sheet, 0.25));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/bodies/0/shape/surface");
    EXPECT_THAT(error.problem(), HasSubstr("surface.off: has no inside"));
  }
}

TEST_F(SurfaceWorld, TheSecondWorldIsTheSameAndBothCanBeCancelled) {
  const Scene scene = shot(torus_surface(0.4, 0.15, 12, 6), 0.3);
  Monitor unwilling;
  unwilling.cancelled = [] { return true; };
  EXPECT_THROW(World(scene, unwilling), Cancelled);
  const World first(scene), second(scene);  // the second finds the mesh in the cache
  EXPECT_THROW(World(scene, unwilling), Cancelled);
  EXPECT_EQ(first.state_hash(), second.state_hash());
}

}  // namespace
}  // namespace griffith
