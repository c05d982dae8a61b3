#include "sim/world/output/node_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

TEST(NodeReport, WhatItShowsIsOfOneMomentAndAddsUp) {
  World world(shot_wall(Vec3(2, 2, 0.5), 0.25, brick(0.5)));
  int by_tension_alone = 0, after_cracks = 0;
  for (int step = 0; step < 30; ++step) {
    world.step();
    const Frame frame = world.frame();
    for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
      const NodeReport report = node_report(frame, NodeId(static_cast<std::int64_t>(i)));
      EXPECT_EQ(report.strained, !frame.bodies[report.body].rigid);
      if (!report.strained) continue;
      double sum = report.balance, scale = 1e-6;
      for (const ElementContribution& element : report.elements) {
        sum += element.contribution;
        scale += std::abs(element.contribution) + element.force.tensile.norm() + element.force.compressive.norm();
      }
      EXPECT_NEAR(sum, report.sum(), 1e-9 * scale) << "node " << i << ", step " << step;
      EXPECT_EQ(report.elements.size(), frame.nodes.stars[i].size());
      EXPECT_EQ(report.load, report.plane.stress);
      if (report.by_tension) {
        EXPECT_EQ(report.load, report.sum());
      } else {
        EXPECT_TRUE(report.load <= 0 || report.sum() > 0) << "a load comes from a pull";
        EXPECT_NEAR(report.principal.values[2], report.sum(), 1e-8 * scale) << "no direction is weaker";
      }
      by_tension_alone += report.load > 1 && report.principal.values[2] < 1e-9 * report.load;
      after_cracks += report.load > 1 && frame.nodes.separations[i].tensor.isZero(0);
    }
  }
  EXPECT_GT(by_tension_alone, 10) << "a star of one element has no tensor";
  EXPECT_GT(after_cracks, 10) << "nodes that cracked in the last substep";
}

TEST(NodeReport, ARigidPieceHasNoStressToReport) {
  Scene scene = shot_wall(Vec3(1, 1, 0.5), 0.25, brick(100));
  scene.projectiles.clear();
  scene.bodies[0].supports.clear();
  World world(scene);
  for (int step = 0; step < 60 && most_loaded_node(world.frame()).valid(); ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_FALSE(most_loaded_node(frame).valid()) << "it lies still";
  const NodeReport report = node_report(frame, NodeId(0));
  EXPECT_FALSE(report.strained);
  EXPECT_TRUE(report.elements.empty());
}

TEST(NodeReport, ElementsAreRankedByTheirShare) {
  World world(struck_block(brick(50)));
  for (int step = 0; step < 8; ++step) world.step();
  const Frame frame = world.frame();
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const NodeReport report = node_report(frame, NodeId(static_cast<std::int64_t>(i)));
    std::set<TetId> seen;
    for (std::size_t k = 0; k < report.elements.size(); ++k) {
      seen.insert(report.elements[k].tet);
      EXPECT_TRUE(k == 0 || report.elements[k - 1].contribution >= report.elements[k].contribution);
    }
    EXPECT_EQ(seen.size(), report.elements.size());
  }
}

TEST(NodeReport, AllCopiesOfABrokenNodeKnowWhereItBroke) {
  World world(shot_wall(Vec3(2, 2, 0.5), 0.25, brick(0.5)));
  for (int step = 0; step < 30; ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.crack_events.size(), 5u);
  for (std::size_t k = 0; k < frame.crack_events.size(); ++k) {
    int knowing = 0;
    for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
      if (frame.nodes.rest_positions[i] != frame.crack_events[k].rest_position) continue;
      const std::vector<int> events = node_report(frame, NodeId(static_cast<std::int64_t>(i))).events;
      EXPECT_NE(std::ranges::find(events, static_cast<int>(k)), events.end());
      ++knowing;
    }
    EXPECT_GE(knowing, 1);
  }
}

TEST(NodeReport, MostLoadedNodeHasTheLargestUtilizationOfWhatIsElastic) {
  World world(shot_wall(Vec3(2, 2, 0.5), 0.25, brick(20)));
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  const NodeId node = most_loaded_node(frame);
  ASSERT_TRUE(node.valid());
  for (const NodeSeparation& separation : frame.nodes.separations)
    EXPECT_LE(separation.utilization, frame.nodes.separations[node].utilization);
  EXPECT_FALSE(most_loaded_node(Frame{}).valid());
}

TEST(PublishedFrame, CrackFacesAndNoOthersHaveTheTimeTheyWereOpened) {
  Scene scene = shot_wall(Vec3(2, 2, 0.5), 0.25, brick(0.5));
  for (const bool remeshing : {false, true}) {
    scene.bodies[0].remeshing = remeshing;
    World world(scene);
    for (int step = 0; step < 16; ++step) world.step();
    const Frame frame = world.frame();
    int opened = 0;
    for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
      for (int face = 0; face < 4; ++face) {
        const bool crack =
            !frame.elements.neighbors[tet][face].valid() && !(frame.elements.first_surface[tet] >> face & 1);
        const double time = frame.elements.opened[tet][face];
        EXPECT_EQ(crack, !std::isnan(time)) << "tet " << tet << ", face " << face;
        EXPECT_TRUE(!crack || (time > 0 && time <= frame.time));
        opened += crack;
      }
    }
    EXPECT_GT(opened, 10);
  }
}

TEST(PublishedFrame, ContactsOfASupportedLoadCarryItsWeight) {
  // A block at rest on the ground: over a step the ground gives it the impulse of its weight.
  Scene scene;
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet};
  block.position = Vec3(0, 0.5, 0);
  block.material = brick(100);
  scene.bodies = {block};
  World world(scene);
  for (int step = 0; step < 40; ++step) world.step();
  Vec3 impulse = Vec3::Zero();
  for (int step = 0; step < 20; ++step) {
    world.step();
    const Frame frame = world.frame();
    for (const ContactView& contact : frame.contacts) {
      EXPECT_NEAR(contact.position.y(), 0, 0.02);
      EXPECT_NEAR(contact.normal.norm(), 1, 1e-9);
      EXPECT_NE(contact.a.valid(), contact.b.valid());
      impulse += contact.a.valid() ? contact.impulse : Vec3(-contact.impulse);
    }
  }
  const double weight = 1900 * 9.81 * 20 * scene.simulation.time_step;
  EXPECT_NEAR(impulse.y(), weight, 0.05 * weight);
}

TEST(PublishedFrame, LoadForcesAddUpToTheLoad) {
  Scene scene = shot_wall(Vec3(1, 1, 0.5), 0.25, brick(100));
  scene.projectiles.clear();
  Load load;
  load.region = HalfSpaceRegion{Vec3(0, 0.5, 0), Vec3::UnitY()};
  load.force = Vec3(30, -70, 5);
  scene.bodies[0].loads = {load};
  World world(scene);
  world.step();
  const Frame frame = world.frame();
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : frame.nodes.load_forces) sum += force;
  EXPECT_LT((sum - load.force).norm(), 1e-9);
}

}  // namespace
}  // namespace griffith::testing
