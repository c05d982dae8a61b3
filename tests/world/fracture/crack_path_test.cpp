#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/world/loading.h"

namespace griffith::testing {
namespace {

BodyDescription concrete_body(const Shape& shape) {
  BodyDescription body;
  body.shape = shape;
  body.material = *find_material_preset("concrete");
  body.elements = ElementOrder::linear;
  return body;
}

Load pull(const Region& region, const Vec3& traction) {
  Load load;
  load.kind = LoadKind::traction;
  load.region = region;
  load.traction = traction;
  return load;
}

Load push(const Region& region, const Vec3& force) {
  Load load;
  load.region = region;
  load.force = force;
  return load;
}

Region line(double x, double y) { return BoxRegion{Vec3(x - 1e-6, y - 1e-6, -1), Vec3(x + 1e-6, y + 1e-6, 1)}; }

Scene weightless(const BodyDescription& body) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.bodies = {body};
  return scene;
}

class CrackPath : public ::testing::TestWithParam<BoxPattern> {};

TEST_P(CrackPath, ABentBeamCracksFromBelowInItsMiddle) {
  const double span = 1.8, depth = 0.4, width = 0.1;
  BodyDescription beam = concrete_body(BoxShape{Vec3(2, depth, width), Vec3::Constant(0.05), GetParam()});
  for (double x : {-span / 2, span / 2}) {
    Support bearing;
    bearing.kind = SupportKind::sliding;
    bearing.region = line(x, -depth / 2);
    beam.supports.push_back(bearing);
  }
  const double load = 2 * width * depth * depth * beam.material.tensile_strength / (3 * span);  // σ = 3PL/2bd²
  beam.loads = {push(line(0, depth / 2), Vec3(0, -load, 0))};
  const double fraction = breaking_fraction(weightless(beam), {0.8, 1.6, 0.01}, has_cracked, [&](const Frame& frame) {
    const CrackEvent& first = frame.crack_events.front();
    EXPECT_NEAR(first.rest_position.y(), -depth / 2, 1e-6);
    EXPECT_LT(std::abs(first.rest_position.x()), span / 10);
    EXPECT_GT(std::abs(first.normal.x()), 0.95);
  });
  // Linear tets eight deep are some 5 to 20 % too stiff in bending.
  EXPECT_GT(fraction, 0.9);
  EXPECT_LT(fraction, 1.3);
}

/// An edge crack a quarter of the width deep in a plate 4 m wide, pulled across.
Scene notched_plate(BoxPattern pattern, int cells) {
  const double width = 4, h = width / cells;
  BodyDescription plate =
      concrete_body(NotchedBeamShape{Vec3(1.5 * width, width, h), width / 4, Vec3::Constant(h), pattern});
  for (double side : {-1.0, 1.0})
    plate.loads.push_back(
        pull(HalfSpaceRegion{Vec3(side * 0.75 * width, 0, 0), Vec3(side, 0, 0)}, Vec3(side * 1e6, 0, 0)));
  return weightless(plate);
}

/// Nothing cracks here: equilibrium is linear, so the utilization under the full load gives the bearable fraction.
double bearable_fraction(Scene scene) {
  scene.analysis = Analysis::static_;
  scene.simulation.fracture = false;
  World world(scene);
  world.step();
  return 1 / world.frame().report.peak_utilization;
}

TEST_P(CrackPath, ANotchedPlateCracksFromTheTipAtALoadThatHardlyDependsOnTheMesh) {
  std::vector<double> fractions;
  for (int cells : {8, 16, 32}) fractions.push_back(bearable_fraction(notched_plate(GetParam(), cells)));
  breaking_fraction(notched_plate(GetParam(), 16), {0.98 * fractions[1], 1.02 * fractions[1], 0.02 * fractions[1]},
                    has_cracked, [](const Frame& frame) {
                      const Vec3& place = frame.crack_events.front().rest_position;
                      EXPECT_NEAR(place.x(), 0, 1e-6);
                      EXPECT_NEAR(place.y(), -1, 1e-6) << "the notch ends one meter above the edge at -2 m";
                    });
  const auto [minimum, maximum] = std::minmax_element(fractions.begin(), fractions.end());
  EXPECT_LT(*maximum / *minimum, 1.15);
  // K = 1.5 σ √(πa) of an edge crack over a quarter of the width (Tada): 0.45 MPa; c scatters by a third with the
  // pattern.
  EXPECT_GT(*minimum, 0.45 * 0.6);
  EXPECT_LT(*maximum, 0.45 * 1.3);
}

/// G varies along the front of a crack by less than with linear ones, and strength does not replace it on fine meshes.
TEST_P(CrackPath, QuadraticElementsAgreeOnTheLoadOfANotch) {
  for (const int cells : {8, 32}) {
    if (cells == 32 && GetParam() != BoxPattern::five_tet) continue;  // the others are large
    Scene scene = notched_plate(GetParam(), cells);
    scene.bodies[0].elements = ElementOrder::quadratic;
    EXPECT_NEAR(bearable_fraction(scene), 0.425, 0.03) << cells;
  }
}

TEST_P(CrackPath, ADiscSplitsAlongItsLoad) {
  const double radius = 0.5, thickness = 0.1;
  BodyDescription disc = concrete_body(DiscShape{radius, thickness, Vec2(0.0625, 0.05), GetParam()});
  // Spread over pads as in the laboratory, so that it is not the loaded points that fail.
  const double pad = 0.16;
  const double load = std::numbers::pi * radius * thickness * disc.material.tensile_strength;  // σ = 2P/πDt
  for (double side : {-1.0, 1.0})
    disc.loads.push_back(
        pull(BoxRegion{Vec3(-pad / 2, side > 0 ? 0.47 : -0.51, -1), Vec3(pad / 2, side > 0 ? 0.51 : -0.47, 1)},
             Vec3(0, -side * load / (pad * thickness), 0)));
  breaking_fraction(weightless(disc), {0.9, 1.5, 0.01}, has_cracked, [&](const Frame& frame) {
    const CrackEvent& first = frame.crack_events.front();
    EXPECT_LT(std::abs(first.rest_position.x()), 0.05 * radius) << "on the loaded diameter";
    EXPECT_GT(std::abs(first.normal.x()), 0.97) << "across the load";
  });

  if (GetParam() == BoxPattern::bcc) return;  // cracks are rough there: no face lies in a lattice plane
  // Compressed between platens, so that the load falls as the disc breaks.
  for (std::size_t i = 0; i < 2; ++i) {
    Support platen;
    platen.kind = SupportKind::prescribed;
    platen.region = disc.loads[i].region;
    platen.velocity = 1e-3 * disc.loads[i].traction.normalized();
    platen.can_tear = false;
    disc.supports.push_back(platen);
  }
  disc.loads.clear();
  Scene scene = weightless(disc);
  scene.analysis = Analysis::static_;
  scene.simulation.time_step = 0.01;
  World world(scene);
  while (!has_parted(world.frame()) && world.frame().time < 1) world.step();
  ASSERT_TRUE(has_parted(world.frame()));
  // Two halves, left and right; a half disc's center lies 4R/3π from the cut.
  std::vector<BodyView> pieces(world.frame().bodies.begin(), world.frame().bodies.end());
  std::ranges::sort(pieces, std::greater{}, &BodyView::tets);
  EXPECT_GT(pieces[0].mass + pieces[1].mass, 0.9 * world.frame().totals.mass);
  EXPECT_LT(pieces[0].center_of_mass.x() * pieces[1].center_of_mass.x(), 0);
  for (const BodyView& half : {pieces[0], pieces[1]}) {
    EXPECT_NEAR(std::abs(half.center_of_mass.x()), 4 * radius / (3 * std::numbers::pi), 0.1 * radius);
    EXPECT_NEAR(half.center_of_mass.y(), 0, 0.1 * radius);
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, CrackPath,
                         ::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc));

}  // namespace
}  // namespace griffith::testing
