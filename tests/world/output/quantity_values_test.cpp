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

/// A beam along x of 2 x 0.2 x 0.2 m whose right end is pulled down with 1 kN.
Scene bent_beam(ElementOrder elements) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.analysis = Analysis::static_;
  BodyDescription beam;
  beam.shape = BoxShape{Vec3(2, 0.2, 0.2), Vec3::Constant(0.1), BoxPattern::five_tet};
  beam.elements = elements;
  beam.material = *find_material_preset("mild_steel");
  beam.supports = {{HalfSpaceRegion{Vec3(-1, 0, 0), -Vec3::UnitX()}}};
  Load load;
  load.region = HalfSpaceRegion{Vec3(1, 0, 0), Vec3::UnitX()};
  load.kind = LoadKind::traction;
  load.traction = Vec3(0, -25000, 0);
  beam.loads = {load};
  scene.bodies = {beam};
  return scene;
}

TEST(LinearValues, HaveTheMeanOfTheTetAndTheStressOfABeam) {
  World world(bent_beam(ElementOrder::quadratic));
  world.step();
  const Frame frame = world.frame();
  const Quantity& pressure = *find_quantity("pressure");
  const QuantityValues corners = linear_values(frame, pressure), means = quantity_values(frame, pressure);
  ASSERT_EQ(corners.place, ValuePlace::corner);
  ASSERT_EQ(corners.values.size(), 4 * means.values.size());
  const QuantityValues tension = linear_values(frame, *find_quantity("max_principal_stress"));
  int compared = 0;
  for (std::size_t tet = 0; tet < means.values.size(); ++tet) {
    const float* at = &corners.values[4 * tet];
    EXPECT_NEAR((at[0] + at[1] + at[2] + at[3]) / 4, means.values[tet], 500) << tet;  // Pa, of 1 MPa
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Vec3 place = frame.nodes.rest_positions[frame.elements.tets[TetId(static_cast<int>(tet))][corner]];
      if (std::abs(place.x()) > 0.7 || place.y() < 0.0999) continue;
      const double moment = 1000 * (1 - place.x()), second_moment = std::pow(0.2, 4) / 12;
      EXPECT_NEAR(tension.values[4 * tet + corner], moment * place.y() / second_moment, 0.05e6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(LinearValues, AreThoseOfTheTetsWithoutQuadraticOnes) {
  World world(bent_beam(ElementOrder::linear));
  world.step();
  for (const Quantity* quantity : view_quantities()) {
    if (!quantity->has_values()) continue;
    const QuantityValues values = quantity_values(world.frame(), *quantity);
    EXPECT_EQ(linear_values(world.frame(), *quantity).place, values.place);
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
