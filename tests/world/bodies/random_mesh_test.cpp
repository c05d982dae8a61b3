#include <gtest/gtest.h>

#include <set>

#include "sim/core/error.h"
#include "sim/core/temporary_folder.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/world/world.h"
#include "tests/random_values.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

/// A scene of one body, of a mesh in a file of its own.
struct MeshScene {
  explicit MeshScene(const TetSoup& soup) {
    write_tetgen(folder.path() / "mesh.node", soup);
    BodyDescription body;
    body.name = "rock";
    body.shape = MeshFileShape{folder.path() / "mesh.node", 1};
    scene.bodies = {body};
  }
  BodyDescription& body() { return scene.bodies[0]; }

  TemporaryFolder folder;
  Scene scene;
};

/// Two cubes of equal cells that meet in an edge, or in a corner alone.
TetSoup two_cubes(bool in_an_edge) {
  TetSoup soup = make_box(Vec3(2, 2, 2), Vec3::Ones(), BoxPattern::five_tet);
  std::erase_if(soup.tets, [&](const auto& tet) {
    const Vec3 middle = (soup.points[tet[0]] + soup.points[tet[1]] + soup.points[tet[2]] + soup.points[tet[3]]) / 4;
    const bool low = middle.x() < 0 && middle.y()<0, high = middle.x()> 0 && middle.y() > 0;
    return in_an_edge ? middle.z() > 0 || !(low || high) : !((low && middle.z() < 0) || (high && middle.z() > 0));
  });
  return soup;
}

TEST(TouchingPieces, AreBodiesOfTheirOwn) {
  for (const bool in_an_edge : {true, false}) {
    MeshScene mesh(two_cubes(in_an_edge));
    mesh.scene.ground.reset();
    World world(mesh.scene);
    ASSERT_EQ(world.frame().bodies.size(), 2u);
    EXPECT_EQ(world.frame().nodes.positions.size(), 16u) << "each has eight nodes of its own";
    EXPECT_NEAR(world.frame().totals.mass, 2 * mesh.body().material.density, 1e-9);
    EXPECT_TRUE(std::ranges::any_of(world.findings(), [](const InputError& finding) {
      return finding.problem().find("joined parts that share no face there; parted, the first at (0, 0,") !=
             std::string::npos;
    }));
    for (int step = 0; step < 5; ++step) world.step();
    const double t = 5 * mesh.scene.simulation.time_step;
    for (const BodyView& body : world.frame().bodies) EXPECT_NEAR(body.velocity.y(), -9.81 * t, 1e-6) << "both fall";
  }
}

TEST(TouchingPieces, AreHeldWhereAListNamesTheNodeThatTheyHadInCommon) {
  const TetSoup soup = two_cubes(false);
  MeshScene mesh(soup);
  int common = 0;
  while (!soup.points[common].isZero(0)) ++common;
  mesh.body().supports = {{.region = NodeListRegion{{common}}}};
  const World world(mesh.scene);
  std::set<BodyId> held;
  const Frame frame = world.frame();
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (NodeId node : frame.elements.tets[tet])
      if (frame.nodes.has_support[node]) held.insert(frame.elements.bodies[tet]);
  EXPECT_EQ(held.size(), 2u);
}

/// Any of a lattice's tets, which touch in all the ways in which tets can.
TetSoup random_lattice(RandomValues& random) {
  const BoxPattern pattern = std::array{BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc}[random.index(3)];
  TetSoup soup = make_box(Vec3(2, 2, 2), Vec3::Ones(), pattern);
  const double fraction = random.uniform(0.1, 0.9);
  std::erase_if(soup.tets, [&](const auto&) { return random.uniform(0, 1) > fraction; });
  if (soup.tets.empty()) soup = make_box(Vec3(2, 2, 2), Vec3::Ones(), pattern);
  return soup;
}

/// Moves corners next to the middles of the faces opposite them: slivers of any flatness down to `minimum`.
void flatten_some(TetSoup& soup, RandomValues& random, double minimum) {
  for (const auto& tet : soup.tets) {
    if (random.index(6) > 0) continue;
    const Vec3 middle = (soup.points[tet[1]] + soup.points[tet[2]] + soup.points[tet[3]]) / 3;
    soup.points[tet[0]] = middle + std::pow(minimum, random.uniform(0, 1)) * (soup.points[tet[0]] - middle);
  }
}

/// Weak material, so that much breaks, on the ground, some of it held.
Scene random_setting(Scene scene, RandomValues& random) {
  BodyDescription& body = scene.bodies[0];
  body.position = Vec3(0, random.uniform(0.5, 2), 0);
  body.velocity = Vec3(0, -random.uniform(0, 10), 0);
  body.material = brick(std::pow(10, random.uniform(-3, 0)));
  body.material.element_model = random.index(2) == 0 ? ElementModel::green_strain : ElementModel::corotational;
  body.remeshing = random.index(2) == 0;
  if (random.index(3) == 0) body.supports = {{HalfSpaceRegion{Vec3::Zero(), -Vec3::UnitY()}}};
  if (random.index(6) == 0) scene.analysis = Analysis::static_;
  if (random.index(2) == 0) body.elements = ElementOrder::quadratic;
  if (random.index(3) == 0) body.material.yield_strength = 0.5 * body.material.tensile_strength;
  return scene;
}

void expect_finite(const Frame& frame) {
  for (const Vec3& position : frame.nodes.positions) ASSERT_TRUE(position.allFinite());
  for (const Vec3& velocity : frame.nodes.velocities) ASSERT_TRUE(velocity.allFinite());
  for (const Mat3& stress : frame.elements.stresses) ASSERT_TRUE(stress.allFinite());
  EXPECT_TRUE(std::isfinite(frame.totals.kinetic_energy) && std::isfinite(frame.totals.elastic_energy));
}

TEST(RandomMeshes, OfTetsThatTouchInAnyWayRun) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomValues random(seed);
    const MeshScene mesh(random_lattice(random));
    World world(random_setting(mesh.scene, random));
    for (int step = 0; step < 5; ++step) {
      world.step();
      EXPECT_EQ(world.frame().report.non_finite_values, 0);
    }
    expect_finite(world.frame());
  }
}

TEST(RandomMeshes, OfSliversRun) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    RandomValues random(seed);
    TetSoup soup = random_lattice(random);
    flatten_some(soup, random, 1e-6);
    const MeshScene mesh(soup);
    World world(random_setting(mesh.scene, random));
    for (int step = 0; step < 5; ++step) {
      world.step();
      EXPECT_EQ(world.frame().report.non_finite_values, 0);
    }
    expect_finite(world.frame());
  }
}

}  // namespace
}  // namespace griffith::testing
