#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/parallel.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/subdivision.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith {
namespace {

using testing::brick;
using testing::struck_block;

Scene remeshed(Scene scene, ElementOrder order = ElementOrder::linear) {
  for (BodyDescription& body : scene.bodies) body.remeshing = true, body.elements = order;
  return scene;
}

class RemeshedOrders : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(Orders, RemeshedOrders, ::testing::Values(ElementOrder::linear, ElementOrder::quadratic));

double volume(const Frame& frame) {
  double sum = 0;
  for (const auto& [a, b, c, d] : frame.elements.tets) {
    const auto& x = frame.nodes.rest_positions;
    sum += signed_volume(x[a], x[b], x[c], x[d]);
  }
  return sum;
}

double worst_quality(const Frame& frame) {
  double worst = 1;
  for (const auto& [a, b, c, d] : frame.elements.tets) {
    const auto& x = frame.nodes.rest_positions;
    worst = std::min(worst, tet_quality(x[a], x[b], x[c], x[d]));
  }
  return worst;
}

TEST_P(RemeshedOrders, KeepMomentumThroughAnImpactThatCutsABlock) {
  World world(remeshed(struck_block(brick(0.1)), GetParam()));
  const std::size_t tets = world.frame().elements.tets.size();
  const double initial_volume = volume(world.frame());
  world.step();  // the sphere is launched
  const Totals before = world.frame().totals;
  for (int step = 0; step < 120; ++step) {
    world.step();
    const Totals now = world.frame().totals;
    ASSERT_NEAR(now.mass, before.mass, 1e-9 * before.mass);
    ASSERT_LT((now.momentum - before.momentum).norm(), 1e-6 * before.momentum.norm()) << "step " << step;
    ASSERT_LT((now.angular_momentum - before.angular_momentum).norm(), 1e-2 * before.angular_momentum.norm())
        << "step " << step;
    ASSERT_LE(now.kinetic_energy + now.elastic_energy, before.kinetic_energy * (1 + 1e-6)) << "step " << step;
    ASSERT_EQ(world.frame().report.non_finite_values, 0);
    ASSERT_LT(std::abs(world.frame().energy.unaccounted()), 0.01 * before.kinetic_energy) << "step " << step;
  }
  EXPECT_GT(world.frame().bodies.size(), 1u) << "it did break";
  EXPECT_GT(world.frame().elements.tets.size(), tets) << "tets were cut";
  EXPECT_NEAR(volume(world.frame()), initial_volume, 1e-9 * initial_volume);
  EXPECT_GE(worst_quality(world.frame()), 0.1);
}

TEST(Remeshing, WhatIsTooSmallToBreakIsNotCut) {
  Scene scene = remeshed(struck_block(brick(0.1)));
  scene.simulation.min_fragment_tets = 1000;
  World world(scene);
  const std::size_t tets = world.frame().elements.tets.size();
  ASSERT_LT(tets, 1000u);
  int suppressed = 0;
  for (int step = 0; step < 60; ++step) {
    world.step();
    suppressed += world.frame().report.cracks_suppressed;
  }
  EXPECT_GT(suppressed, 0);
  EXPECT_EQ(world.frame().elements.tets.size(), tets);
}

TEST_P(RemeshedOrders, AreTheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    World world(remeshed(struck_block(brick(0.2)), GetParam()));
    for (int step = 0; step < 20; ++step) world.step();
    EXPECT_GT(world.frame().fragments, 0);
    hashes.push_back(world.state_hash());
  }
  EXPECT_THAT(hashes, ::testing::Each(hashes.front()));
}

/// A spinning body that is cut with nothing acting on it.
TEST_P(RemeshedOrders, KeepTheMomentaOfASpinningBody) {
  Scene scene = remeshed(struck_block(brick(0.1)), GetParam());
  scene.projectiles.clear();
  scene.bodies[0].velocity = Vec3(1, 2, 3);
  scene.bodies[0].angular_velocity = Vec3(1, 2, 60);  // more than it bears
  World world(scene);
  const std::size_t tets = world.frame().elements.tets.size();
  const Totals before = world.frame().totals;
  for (int step = 0; step < 20 && world.frame().elements.tets.size() == tets; ++step) world.step();
  ASSERT_GT(world.frame().elements.tets.size(), tets);
  const Totals after = world.frame().totals;
  // Elements' forces are in single precision.
  EXPECT_LT((after.momentum - before.momentum).norm(), 1e-8 * before.momentum.norm());
  EXPECT_LT((after.angular_momentum - before.angular_momentum).norm(), 1e-4 * before.angular_momentum.norm());
}

/// A plate that lies on a smooth table and is pulled apart, so that it cracks across the supported face, too.
Scene plate_pulled_apart(double width) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription plate;
  plate.shape = BoxShape{Vec3(2, 1, width), Vec3::Constant(0.3), BoxPattern::five_tet};
  plate.material = brick(0.1);
  plate.remeshing = true;
  const HalfSpaceRegion foot{Vec3(0, -0.5, 0), -Vec3::UnitY()};
  plate.supports = {{.region = foot, .kind = SupportKind::sliding, .normal = Vec3::UnitY()}};
  for (double side : {-1.0, 1.0}) {
    plate.supports.push_back({.region = HalfSpaceRegion{Vec3(side, 0, 0), Vec3(side, 0, 0)},
                              .kind = SupportKind::prescribed,
                              .velocity = Vec3(0.05 * side, 0, 0.05 * side)});
  }
  scene.bodies = {plate};
  return scene;
}

TEST(Remeshing, SupportsHoldTheMiddleOfAnEdgeWhereTheyHoldBothEnds) {
  int on_cut_edges = 0;  // not every crack cuts one
  for (const double width : {0.5, 0.55, 0.6, 0.7}) {
    World world(plate_pulled_apart(width));
    const std::size_t nodes = world.frame().nodes.positions.size();
    for (int step = 0; step < 60; ++step) world.step();
    const Frame frame = world.frame();
    EXPECT_GT(frame.fragments, 0);
    for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node) {
      if (frame.nodes.rest_positions[node].y() > -0.5 + 1e-9 || !frame.nodes.has_support[node]) continue;
      on_cut_edges +=
          std::ranges::count(frame.nodes.rest_positions.first(nodes), frame.nodes.rest_positions[node]) == 0;
      EXPECT_NEAR(frame.nodes.positions[node].y(), -0.5, 1e-8) << "node " << node;
    }
  }
  EXPECT_GT(on_cut_edges, 0);
}

/// A block whose foot is moved until `stop` [s], halved across an edge between two of its held nodes in the middle of
/// the step that stops it.
struct HalvedAtItsFoot {
  WorldState world;
  Subdivision cut;

  explicit HalvedAtItsFoot(double stop) : world(build_world(scene(stop))) {
    while (world.time + world.model->scene.simulation.time_step < stop) advance(world);
    update_supports(world, world.time, world.model->scene.simulation.time_step);
    world.time += 0.5 * world.model->scene.simulation.time_step;
    const auto& corners = world.mesh->tets[0];
    std::vector<NodeId> held;
    std::ranges::copy_if(corners, std::back_inserter(held),
                         [&](NodeId node) { return world.nodes.has_support[node] != 0; });
    bisect_edge(world.mesh.edit(), held.at(0), held.at(1), 0.4, cut);
    follow_subdivision(world, cut);
  }
  static Scene scene(double stop) {
    Scene scene;
    scene.gravity.setZero();
    scene.ground.reset();
    scene.simulation.fracture = false;
    BodyDescription block;
    block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::kuhn};
    block.remeshing = true;
    block.supports = {{.region = HalfSpaceRegion{Vec3(0, -0.5, 0), -Vec3::UnitY()},
                       .kind = SupportKind::prescribed,
                       .velocity = Vec3(0.1, 0, 0),
                       .stop = stop}};
    scene.bodies = {block};
    return scene;
  }
};

/// A quadratic block in which strain is linear. A small one, for which both strain measures are the same.
struct BentBlock {
  WorldState world;

  explicit BentBlock(ElementModel model) : world(build_world(scene(model))) {
    for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
      world.nodes.positions[node] = bent(world.mesh->rest_positions[node]);
    for (std::size_t i = 0; i < world.edges.offsets.size(); ++i) {
      const auto& [a, b] = world.tet_edges->ends[EdgeId(i)];
      const Vec3 &from = world.mesh->rest_positions[a], &to = world.mesh->rest_positions[b];
      world.edges.offsets[EdgeId(i)] = bent((from + to) / 2) - (bent(from) + bent(to)) / 2;
    }
    update_elements(world, world.bodies[0]);
  }
  static Vec3 bent(const Vec3& x) {
    return x + 1e-6 * Vec3(x.x() * x.y() + x.z(), x.y() - 2 * x.z() * x.x(), x.y() * x.y());
  }
  static Scene scene(ElementModel model) {
    Scene scene;
    BodyDescription block;
    block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::kuhn};
    block.elements = ElementOrder::quadratic;
    block.material.element_model = model;
    block.remeshing = true;
    scene.bodies = {block};
    return scene;
  }
};

TEST(Remeshing, AFieldOfQuadraticTetsStaysTheSame) {
  for (const ElementModel model : {ElementModel::corotational, ElementModel::green_strain}) {
    BentBlock block(model);
    WorldState& world = block.world;
    const double energy = elastic_energy(world, world.bodies[0]);
    const TetId tet(3);
    const Mat3 kept = world.elements.quadratic_states[tet].corners[0].stress;
    const std::array<NodeId, 4> corners = world.mesh->tets[tet];
    Subdivision cut;
    bisect_edge(world.mesh.edit(), corners[0], corners[2], 0.3, cut);
    bisect_edge(world.mesh.edit(), corners[1], corners[3], 0.6, cut);
    follow_subdivision(world, cut);
    EXPECT_GT(cut.tets.size(), 2u);
    for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
      EXPECT_LT((world.nodes.positions[node] - BentBlock::bent(world.mesh->rest_positions[node])).norm(), 1e-15);
    EXPECT_NEAR(elastic_energy(world, world.bodies[0]), energy, 1e-5 * energy);
    const Mat3 now = world.elements.quadratic_states[tet].corners[0].stress;
    EXPECT_LT((now - kept).norm(), 1e-5 * kept.norm());
  }
}

TEST(Remeshing, SupportsGoOnAsTheyDoAtThatMoment) {
  for (const double stop : {0.03, 0.045}) {
    HalvedAtItsFoot halved(stop);
    const Vec3 velocity = halved.world.time < stop ? Vec3(0.1, 0, 0) : Vec3(0, 0, 0);
    EXPECT_EQ(halved.world.time < stop, stop == 0.03);
    int held = 0;
    for (const NodeId node : IdRange<NodeId>(0, halved.world.mesh->node_count())) {
      if (!halved.world.nodes.has_support[node]) continue;
      EXPECT_LT((halved.world.nodes.constraints[node].velocity - velocity).norm(), 1e-12) << "node " << node.index();
      ++held;
    }
    EXPECT_EQ(held, 10) << "the new node is held, too";
  }
}

TEST(Remeshing, ABodyThatIsTornOffInTheRoundIsNotGivenASpin) {
  HalvedAtItsFoot halved(0.03);
  WorldState& world = halved.world;
  MotionsBefore motions;
  record_motion(world, world.bodies[0], motions);
  std::ranges::fill(world.nodes.has_support, 0);
  record_motion(world, world.bodies[0], motions);  // its new node is not among the body's yet
  const std::vector<Vec3> velocities = world.nodes.velocities;
  restore_momenta(world, motions);
  EXPECT_EQ(world.nodes.velocities, velocities);
}

/// A bar with loads on faces, tets and nodes that breaks in weightless space.
TEST(Remeshing, LoadsStayOnTheirMaterial) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.max_cracks_per_step = 4;
  BodyDescription bar;
  bar.shape = BoxShape{Vec3(2, 0.5, 0.5), Vec3::Constant(0.25), BoxPattern::five_tet};
  bar.material = brick(0.01);
  bar.remeshing = true;
  const HalfSpaceRegion everything{Vec3::Zero(), Vec3::UnitX()}, end{Vec3(1, 0, 0), Vec3::UnitX()},
      other_end{Vec3(-1, 0, 0), -Vec3::UnitX()};
  const double area = 0.25;
  Load traction{.region = end, .kind = LoadKind::traction, .traction = Vec3(2e5, 5e4, 3e4)};
  Load pull{.region = other_end, .kind = LoadKind::point_force, .force = Vec3(-3e4, 0, 0)};
  Load push{.region = everything, .kind = LoadKind::body_force, .acceleration = Vec3(0, 5, 0)};
  bar.loads = {traction, pull, push};
  scene.bodies = {bar};
  World world(scene);
  const std::size_t tets = world.frame().elements.tets.size();
  const double half_mass = world.frame().totals.mass / 2;
  const int steps = 15;
  for (int step = 0; step < steps; ++step) world.step();
  EXPECT_GT(world.frame().elements.tets.size(), tets);
  EXPECT_GT(world.frame().fragments, 0);
  const double time = steps * scene.simulation.time_step;
  const Vec3 impulse = time * (area * traction.traction + pull.force + half_mass * push.acceleration);
  EXPECT_LT((world.frame().totals.momentum - impulse).norm(), 1e-6 * impulse.norm());
}

}  // namespace
}  // namespace griffith
