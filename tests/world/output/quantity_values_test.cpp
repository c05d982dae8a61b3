#include "sim/world/output/quantity_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/core/error.h"
#include "sim/world/output/probes.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Scene probed_wall() {
  Scene scene = shot_wall(Vec3(3, 3, 1), 1.5, brick(0.02));
  for (const int node : {0, 4, 9, 13}) {
    Probe probe;
    probe.name = "probe " + std::to_string(node);
    probe.body = "wall";
    probe.at = ProbeNode{node};
    probe.quantities.clear();
    for (const std::string_view key : keys_of(probe_quantities())) probe.quantities.emplace_back(key);
    scene.probes.push_back(probe);
  }
  return scene;
}

World broken_wall() {
  World world(probed_wall());
  for (int i = 0; i < 30; ++i) world.step();
  return world;
}

std::vector<double> numbers_of(double value) { return {value}; }
std::vector<double> numbers_of(const Vec3& value) { return {value.x(), value.y(), value.z()}; }
std::vector<double> numbers_of(const Mat3& value) {
  return {value(0, 0), value(1, 1), value(2, 2), value(0, 1), value(1, 2), value(2, 0)};
}

/// Values of a quantity of nodes at the only node of a probe.
std::vector<double> values_at(const Frame& frame, const Quantity& quantity, const PlacedProbe& probe) {
  const NodeId node = node_at(frame.elements.tets, probe.nodes[0].corner);
  return std::visit([&](const auto& values) { return numbers_of(values[node]); }, quantity_array(frame, quantity));
}

TEST(QuantityValues, AProbeOfANodeMeasuresItsValue) {
  const World world = broken_wall();
  const Frame frame = world.frame();
  ASSERT_GT(frame.bodies.size(), 1u);
  const std::vector<double> measured = probe_values(frame.probes, frame);
  std::size_t column = 0;
  for (const PlacedProbe& probe : frame.probes) {
    for (const std::string& key : probe.probe.quantities) {
      const Quantity& quantity = *find_quantity(key);
      if (place_of(quantity) != ValuePlace::node) {
        column += std::visit([](const auto& values) { return numbers_of(values[0]).size(); },
                             quantity_array(frame, quantity));
        continue;
      }
      for (const double value : values_at(frame, quantity, probe)) {
        // The reactions of copies that cracks made are added to that of the probe.
        if (key != "reaction") {
          EXPECT_EQ(measured[column], value) << probe.probe.name << " " << key;
        }
        ++column;
      }
    }
  }
  EXPECT_EQ(column, measured.size());
  EXPECT_EQ(column, probe_columns(frame.probes).size());
}

TEST(QuantityValues, AProbeMeasuresMeansOfElements) {
  const World world = broken_wall();
  const Frame frame = world.frame();
  const std::vector<std::string> columns = probe_columns(frame.probes);
  const std::vector<double> measured = probe_values(frame.probes, frame);
  for (const char* key : {"pressure", "strain_energy"}) {
    const auto values = std::get<std::vector<double>>(quantity_array(frame, *find_quantity(key)));
    for (const PlacedProbe& probe : frame.probes) {
      const NodeId node = node_at(frame.elements.tets, probe.nodes[0].corner);
      double sum = 0, volume = 0;
      for (const TetId tet : frame.nodes.stars[node]) {
        sum += frame.elements.rest_elements[tet].volume * values[tet];
        volume += frame.elements.rest_elements[tet].volume;
      }
      const std::string name = probe.probe.name + "." + key + " [" + std::string(find_quantity(key)->unit) + "]";
      const auto column = std::ranges::find(columns, name) - columns.begin();
      ASSERT_LT(column, std::ssize(columns)) << name;
      EXPECT_NEAR(measured[column], sum / volume, 1e-9 * std::abs(sum / volume)) << name;
    }
  }
}

double norm_of(double value) { return value; }
template <class Matrix>
double norm_of(const Matrix& value) {
  return value.norm();
}

std::vector<double> norms_of(const QuantityArray& array) {
  std::vector<double> norms;
  std::visit(
      [&](const auto& values) {
        for (const auto& value : values) norms.push_back(norm_of(value));
      },
      array);
  return norms;
}

TEST(QuantityValues, ColorsShowTheNormsOfTheArrays) {
  const World world = broken_wall();
  const Frame frame = world.frame();
  double stress = 0;
  for (const Mat3& of_tet : frame.elements.stresses) stress = std::max(stress, of_tet.norm());
  for (const Quantity* quantity : file_quantities()) {
    const QuantityValues colors = quantity_values(frame, *quantity);
    const std::vector<double> norms = norms_of(quantity_array(frame, *quantity));
    ASSERT_EQ(colors.values.size(), norms.size()) << quantity->key;
    const double noise = quantity->function_of_many ? 1e-7 * stress : 0;  // a kernel of less precision
    for (std::size_t i = 0; i < norms.size(); ++i) {
      if (!std::isfinite(norms[i])) continue;
      EXPECT_NEAR(colors.values[i], norms[i], 1e-6 * std::abs(norms[i]) + noise) << quantity->key;
    }
  }
}

TEST(QuantityValues, FollowInTheMiddleOfTheEdgesOfQuadraticElements) {
  Scene scene;
  scene.ground.reset();
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Ones(), BoxPattern::five_tet};
  block.elements = ElementOrder::quadratic;
  block.supports = {{HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()}}};
  scene.bodies = {block};
  World world(scene);
  for (int i = 0; i < 5; ++i) world.step();
  const Frame frame = world.frame();
  const std::size_t nodes = frame.nodes.positions.size();
  for (const Quantity* quantity : file_quantities()) {
    const std::size_t count =
        std::visit([](const auto& values) { return values.size(); }, quantity_array(frame, *quantity));
    const bool of_nodes = place_of(*quantity) == ValuePlace::node;
    EXPECT_EQ(count, of_nodes ? nodes + frame.edges.ends.size() : frame.elements.tets.size()) << quantity->key;
  }
  const auto displacements = std::get<std::vector<Vec3>>(quantity_array(frame, *find_quantity("displacement")));
  for (std::size_t edge = 0; edge < frame.edges.ends.size(); ++edge) {
    const auto [a, b] = frame.edges.ends[edge];
    const Vec3 middle = 0.5 * (displacements[a] + displacements[b]) + frame.edges.offsets[edge];
    EXPECT_EQ(displacements[nodes + edge], middle);
  }
}

TEST(QuantityTable, KeysDifferAndEachEntryIsUsed) {
  std::set<std::string_view> keys, used;
  for (const std::vector<const Quantity*>& listed : {view_quantities(), probe_quantities(), file_quantities()})
    for (const std::string_view key : keys_of(listed)) used.insert(key);
  for (const Quantity& quantity : quantities()) {
    EXPECT_TRUE(keys.insert(quantity.key).second) << quantity.key;
    EXPECT_EQ(used.count(quantity.key), 1u) << quantity.key;
    EXPECT_EQ(find_quantity(quantity.key), &quantity);
    EXPECT_FALSE(quantity.label.empty() || quantity.meaning.empty()) << quantity.key;
  }
  EXPECT_FALSE(find_quantity("margin"));
}

TEST(QuantityTable, AProbeOfAnUnknownQuantityIsRefused) {
  Scene scene = probed_wall();
  scene.probes[1].quantities = {"speed", "von_mise"};
  try {
    const World world(scene);
    FAIL() << "it was measured";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "#/probes/1/quantities/1");
    EXPECT_NE(error.remedy().find("von_mises"), std::string::npos) << error.remedy();
  }
}

}  // namespace
}  // namespace griffith::testing
