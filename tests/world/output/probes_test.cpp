#include "sim/world/output/probes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Probe probe_at(const ProbePlace& place, const std::vector<std::string>& quantities) {
  Probe probe;
  probe.body = "block";
  probe.at = place;
  probe.quantities = quantities;
  return probe;
}

Scene probed_block(const std::vector<Probe>& probes) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription block;
  block.name = "block";
  block.shape = BoxShape{Vec3(2, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet};
  block.position = Vec3(5, 6, 7);
  block.rotation_degrees = Vec3(0, 90, 0);
  scene.bodies = {block};
  scene.probes = probes;
  return scene;
}

/// A frame of the world's arrays as they are now.
Frame frame_of(const WorldState& world) {
  Frame frame;
  frame.nodes.rest_positions = world.mesh->rest_positions;
  frame.nodes.positions = world.nodes.positions;
  frame.nodes.velocities = world.nodes.velocities;
  frame.nodes.separations = world.nodes.separations;
  frame.nodes.reactions = world.nodes.reactions;
  frame.elements.tets = world.mesh->tets;
  frame.elements.rest_elements = world.elements.rest_elements;
  frame.elements.states = world.elements.states;
  frame.elements.stresses = world.elements.stresses;
  return frame;
}

TEST(Probes, APointSeesALinearFieldExactly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(-0.5, 0.5);
  const Mat3 gradient{{1, 2, 3}, {-4, 5, 6}, {7, 8, -9}};
  for (int i = 0; i < 30; ++i) {
    const Vec3 point(2 * in(random), in(random), in(random));
    WorldState world = build_world(probed_block({probe_at(ProbePoint{point}, {"displacement", "velocity"})}));
    for (std::size_t node = 0; node < world.nodes.positions.size(); ++node) {
      const Vec3& rest = world.mesh->rest_positions[node];
      world.nodes.positions[node] = rest + gradient * rest;
      world.nodes.velocities[node] = gradient.transpose() * rest;
    }
    const Vec3 placed = Vec3(5, 6, 7) + Vec3(point.z(), point.y(), -point.x());  // turned by 90° about y
    const std::vector<double> values = probe_values(world.probes, frame_of(world));
    ASSERT_EQ(values.size(), 6u);
    EXPECT_LT((Vec3(values.data()) - gradient * placed).norm(), 1e-11);
    EXPECT_LT((Vec3(values.data() + 3) - gradient.transpose() * placed).norm(), 1e-11);
  }
}

TEST(Probes, APointOutsideSeesTheNearestOfTheBody) {
  WorldState world = build_world(probed_block({probe_at(ProbePoint{Vec3(9, 0.2, -0.1)}, {"velocity"})}));
  for (std::size_t node = 0; node < world.nodes.positions.size(); ++node)
    world.nodes.velocities[node] = world.mesh->rest_positions[node];
  const std::vector<double> values = probe_values(world.probes, frame_of(world));
  EXPECT_LT((Vec3(values.data()) - Vec3(5 - 0.1, 6 + 0.2, 7 - 1)).norm(), 1e-12);
}

TEST(Probes, AUniformStressIsTheSameEverywhere) {
  const std::vector<std::string> stresses = {"stress", "principal_stress"};
  WorldState world = build_world(probed_block({probe_at(ProbePoint{}, stresses), probe_at(ProbeNode{7}, stresses),
                                               probe_at(SphereRegion{Vec3(1, 0, 0), 0.6}, stresses)}));
  const Mat3 stress{{1, 4, 6}, {4, 2, 5}, {6, 5, 3}};
  for (Mat3& of_tet : world.elements.stresses.edit()) of_tet = stress;
  const std::vector<double> values = probe_values(world.probes, frame_of(world));
  ASSERT_EQ(values.size(), 3 * 9u);
  const std::vector<double> components = {1, 2, 3, 4, 5, 6};
  for (int probe = 0; probe < 3; ++probe) {
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(values[9 * probe + i], components[i], 1e-12);
    const Vec3 principal(values.data() + 9 * probe + 6);
    EXPECT_GT(principal[0], principal[1]);
    EXPECT_GT(principal[1], principal[2]);
    EXPECT_NEAR(principal.sum(), stress.trace(), 1e-12);
    EXPECT_NEAR(principal.prod(), stress.determinant(), 1e-11);
  }
}

TEST(Probes, ReactionsAreAddedUpAndOthersAveraged) {
  const Region end = HalfSpaceRegion{Vec3(1, 0, 0), Vec3::UnitX()};
  WorldState world = build_world(probed_block({probe_at(end, {"reaction", "velocity"})}));
  for (std::size_t node = 0; node < world.nodes.positions.size(); ++node) {
    world.nodes.reactions[node] = Vec3(1, 2, 3);
    world.nodes.velocities[node] = Vec3(4, 5, 6);
  }
  const std::vector<double> values = probe_values(world.probes, frame_of(world));
  EXPECT_LT((Vec3(values.data()) - 9 * Vec3(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((Vec3(values.data() + 3) - Vec3(4, 5, 6)).norm(), 1e-12);
}

TEST(Probes, SurviveACrack) {
  const Region everything = HalfSpaceRegion{Vec3(0, -9, 0), Vec3::UnitY()};
  WorldState world =
      build_world(probed_block({probe_at(ProbePoint{}, {"stress"}), probe_at(everything, {"reaction", "separation"})}));
  const int nodes = world.mesh->node_count();
  for (const NodeId node : IdRange<NodeId>(0, nodes)) world.nodes.separations[node].utilization = 2;
  open_cracks(world, 0);
  ASSERT_GT(world.mesh->node_count(), nodes);
  for (std::size_t tet = 0; tet < world.elements.stresses.size(); ++tet)
    world.elements.stresses.edit()[tet] = Mat3::Identity();
  for (Vec3& reaction : world.nodes.reactions) reaction = Vec3::UnitX();
  const std::vector<double> values = probe_values(world.probes, frame_of(world));
  EXPECT_NEAR(values[0], 1, 1e-14);
  EXPECT_EQ(values[6], world.mesh->node_count());  // the copies' reactions, too
}

TEST(Probes, EveryColumnHasAName) {
  const std::vector<std::string> all = {"displacement",     "velocity",   "stress",
                                        "principal_stress", "separation", "reaction"};
  const World world(probed_block({probe_at(ProbePoint{}, all)}));
  const std::vector<std::string> columns = probe_columns(world.frame().probes);
  EXPECT_EQ(columns.size(), probe_values(world.frame().probes, world.frame()).size());
  EXPECT_THAT(columns, ::testing::IsSupersetOf({"probe.displacement.x [m]", "probe.stress.zx [Pa]",
                                                "probe.separation.utilization [-]", "probe.reaction.z [N]"}));
}

TEST(Probes, WhatTheyNameHasToExist) {
  const auto place_of_error = [](const Scene& scene) -> std::string {
    try {
      const World world(scene);
      return "none";
    } catch (const InputError& error) {
      return error.where();
    }
  };
  Probe stranger = probe_at(ProbePoint{}, {"velocity"});
  stranger.body = "blok";
  EXPECT_EQ(place_of_error(probed_block({stranger})), "#/probes/0/body");
  EXPECT_EQ(place_of_error(probed_block({probe_at(ProbeNode{44}, {})})), "none");
  EXPECT_EQ(place_of_error(probed_block({probe_at(ProbeNode{45}, {})})), "#/probes/0/at/node");

  const World world(probed_block({probe_at(SphereRegion{Vec3(0, 9, 0), 1}, {"velocity"})}));
  ASSERT_EQ(world.findings().size(), 1u);
  EXPECT_EQ(world.findings()[0].where(), "#/probes/0/at/region");
  for (const double value : probe_values(world.frame().probes, world.frame())) EXPECT_TRUE(std::isnan(value));
}

}  // namespace
}  // namespace griffith::testing
