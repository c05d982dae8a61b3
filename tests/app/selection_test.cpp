#include "ui/model/selection.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/picking.h"
#include "app/editor/utilization_history.h"
#include "app/shared/explanation.h"
#include "program.h"
#include "sim/world/output/node_report.h"
#include "sim/world/world.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"

namespace griffith::app {
namespace {

Scene weak_wall(bool remeshing) {
  Scene scene = small_wall();
  scene.bodies[0].remeshing = remeshing;
  scene.bodies[0].material.tensile_strength *= 0.2;
  scene.bodies[0].material.fracture_toughness *= 0.2;
  return scene;
}

std::vector<ui::Selection> all_corners(const Frame& frame) {
  std::vector<ui::Selection> selections;
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i)
    for (NodeId node : frame.elements.tets[i])
      selections.push_back(ui::select(frame, TetId(static_cast<std::int64_t>(i)), node));
  return selections;
}

TEST(Selection, SurvivesSplitsAndStaysWithItsPieceOfMaterial) {
  for (const bool remeshing : {false, true}) {
    World world(weak_wall(remeshing));
    std::vector<ui::Selection> selections = all_corners(world.frame());
    const std::vector<ui::Selection> before = selections;
    for (int step = 0; step < 20; ++step) {
      world.step();
      for (ui::Selection& selection : selections) selection = ui::follow(selection, world.frame());
    }
    const Frame frame = world.frame();
    ASSERT_GT(frame.crack_events.size(), 3u);
    int copies = 0;
    for (std::size_t i = 0; i < selections.size(); ++i) {
      const ui::Selection& selection = selections[i];
      ASSERT_TRUE(selection.valid());
      EXPECT_EQ(frame.nodes.rest_positions[selection.node], before[i].rest_position);
      const auto& corners = frame.elements.tets[selection.tet];
      EXPECT_NE(std::ranges::find(corners, selection.node), corners.end());
      EXPECT_TRUE(remeshing || selection.tet == before[i].tet);
      copies += selection.node != before[i].node;
    }
    EXPECT_GT(copies, 0);
  }
}

TEST(Selection, IsTheSameNodeAgainInANewRun) {
  World world(weak_wall(false));
  const ui::Selection first = all_corners(world.frame())[17];
  ui::Selection selection = first;
  for (int step = 0; step < 20; ++step) {
    world.step();
    selection = ui::follow(selection, world.frame());
  }
  World again(weak_wall(false));
  EXPECT_EQ(ui::follow(selection, again.frame()), first);
  EXPECT_FALSE(ui::follow(selection, Frame{}).valid());
}

TEST(UtilizationHistory, HasThePastOfEveryNodeAndOfWhatCopiesWerePartOf) {
  World world(weak_wall(false));
  UtilizationHistory history;
  std::vector<std::vector<double>> utilizations;
  std::vector<double> times;
  for (int step = 0; step < 20; ++step) {
    world.step();
    const Frame frame = world.frame();
    history.record(frame);
    utilizations.emplace_back();
    times.push_back(frame.time);
    for (const NodeSeparation& separation : frame.nodes.separations)
      utilizations.back().push_back(separation.utilization);
  }
  const Frame frame = world.frame();
  ASSERT_GT(frame.nodes.positions.size(), utilizations.front().size());
  for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node) {
    const NodeId id(static_cast<std::int64_t>(node));
    std::size_t steps = 0, breaks = 0;
    for (const ui::UtilizationSample& sample : history.samples(frame, id)) {
      breaks += sample.broke;
      EXPECT_TRUE(!sample.broke || sample.utilization > 1);
      if (sample.broke) continue;
      EXPECT_EQ(sample.time, times[steps]);
      const bool known = node < utilizations[steps].size();
      EXPECT_TRUE(!known || sample.utilization == static_cast<float>(utilizations[steps][node]));
      ++steps;
    }
    EXPECT_EQ(steps, times.size()) << node;
    EXPECT_EQ(breaks, node_report(frame, id).events.size());
  }
}

TEST(UtilizationHistory, ForgetsTheOldestStepsWhenItIsFull) {
  Scene scene = small_wall();
  scene.simulation.fracture = false;  // cracks would make nodes
  World world(scene);
  const std::size_t nodes = world.frame().nodes.positions.size();
  UtilizationHistory history(5 * nodes);
  for (int step = 0; step < 4; ++step) {
    world.step();
    history.record(world.frame());
  }
  EXPECT_EQ(history.samples(world.frame(), NodeId(0)).size(), 4u);
  for (int step = 0; step < 4; ++step) history.record(world.frame());
  EXPECT_EQ(history.samples(world.frame(), NodeId(0)).size(), 5u);
  history.clear();
  EXPECT_TRUE(history.samples(world.frame(), NodeId(0)).empty());
}

TEST(NearestCorner, IsTheOneThatTheRayEntersNearest) {
  World world(small_wall());
  const Frame frame = world.frame();
  const ViewSettings view;
  const ShownMesh shown = shown_mesh(frame, view, {});
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    const TetId tet(static_cast<std::int64_t>(random() % frame.elements.tets.size()));
    const std::size_t wanted = random() % 4;
    // Onto a face near one of its corners, from outside.
    const std::size_t opposite = (wanted + 1 + random() % 3) % 4;
    Vec3 place = Vec3::Zero(), middle = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      middle += frame.nodes.positions[frame.elements.tets[tet][i]] / 4;
      if (i != opposite) place += (i == wanted ? 0.8 : 0.1) * frame.nodes.positions[frame.elements.tets[tet][i]];
    }
    const Vec3 way = (middle - place).normalized();
    const render::Ray ray{(place - 3 * way).cast<float>(), way.cast<float>()};
    EXPECT_EQ(nearest_corner(shown, tet, ray), frame.elements.tets[tet][wanted]);
  }
}

TEST(Verdict, SaysWhetherAndWhyANodeBroke) {
  World world(weak_wall(false));
  for (int step = 0; step < 20; ++step) world.step();
  const Frame frame = world.frame();
  using Kind = ui::Verdict::Kind;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const NodeReport report = node_report(frame, NodeId(static_cast<std::int64_t>(i)));
    const ui::Verdict verdict = ui::verdict_on(report, frame, true);
    EXPECT_FALSE(verdict.text.empty());
    const bool overloaded = report.separation.utilization > 1 && !frame.bodies[report.body].rigid;
    EXPECT_EQ(verdict.kind == Kind::overloaded, overloaded);
    EXPECT_EQ(verdict.kind == Kind::broke, !report.events.empty() && !overloaded);
  }
}

TEST(Verdict, ReportsWhatStoodInForTheMaterial) {
  Scene scene = small_wall();
  scene.simulation.time_step = 0.02;
  scene.simulation.step_budget = 0.1;
  scene.bodies[0].material.young_modulus *= 100;  // for more microsteps than it pays for
  World world(scene);
  while (world.frame().crack_events.empty() && world.frame().step < 60) world.step();
  const Frame frame = world.frame();
  ASSERT_FALSE(frame.crack_events.empty());
  const CrackEvent event = frame.crack_events.front();  // later steps move the others
  ASSERT_TRUE(event.scaled);
  const std::string told = "Broke at " + scale_text(*event.scaled) + ", " +
                           ui::format_quantity(1 / event.scaled->factor, "", 2) + " times slower: ";
  const std::string verdict = ui::verdict_on(node_report(frame, event.node), frame, true).text;
  EXPECT_NE(verdict.find(told + reason(*event.scaled)), std::string::npos) << verdict;
  EXPECT_NE(explanation(frame, event.node, true).find(told), std::string::npos) << "and so does render --node";
  while (world.frame().step < event.step + 3) world.step();
  const NodeReport later = node_report(world.frame(), event.node);
  EXPECT_NE(ui::verdict_on(later, world.frame(), true).text.find(told), std::string::npos)
      << "what broke so long ago did break so";
  while (world.frame().bodies[later.body].scaled && world.frame().step < 200) world.step();
  const Frame end = world.frame();
  for (std::size_t i = 0; i < end.nodes.positions.size(); ++i) {
    const NodeReport report = node_report(end, NodeId(static_cast<std::int64_t>(i)));
    const BodyView& body = end.bodies[report.body];
    const bool is_told = ui::verdict_on(report, end, true).text.find(" times slower: ") != std::string::npos;
    EXPECT_EQ(is_told, body.scaled || body.broke_scaled) << "node " << i;
  }

  scene.simulation.time_step = 1e-3;
  scene.simulation.step_budget = 1000;
  scene.bodies[0].material.young_modulus /= 100;
  World fine(scene);
  while (fine.frame().crack_events.empty() && fine.frame().step < 200) fine.step();
  ASSERT_FALSE(fine.frame().crack_events.empty());
  for (const NodeId node : {fine.frame().crack_events.front().node, NodeId(0)})
    EXPECT_EQ(ui::verdict_on(node_report(fine.frame(), node), fine.frame(), true).text.find("times slower"),
              std::string::npos);
}

TEST(Verdict, KnowsThatTheSceneKeepsItWhole) {
  Scene scene = weak_wall(false);
  scene.simulation.fracture = false;
  World world(scene);
  do {
    world.step();
  } while (world.frame().nodes.separations[most_loaded_node(world.frame())].utilization <= 1 &&
           world.frame().step < 60);
  const Frame frame = world.frame();
  const NodeReport report = node_report(frame, most_loaded_node(frame));
  ASSERT_GT(report.separation.utilization, 1);
  EXPECT_NE(ui::verdict_on(report, frame, false).text.find("does not let bodies break"), std::string::npos);
}

}  // namespace
}  // namespace griffith::app
