#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/validation/specimen.h"

namespace griffith::validation {
namespace {

struct Peak {
  int node = -1;
  Separation separation;
};

/// The largest separation stress among some nodes.
Peak peak(const Specimen& specimen, const std::vector<int>& nodes) {
  Peak best;
  for (int node : nodes) {
    const Separation separation = specimen.separation(node);
    if (best.node < 0 || separation.stress > best.separation.stress) best = {node, separation};
  }
  return best;
}

std::vector<int> all_nodes(const Specimen& specimen) {
  return specimen.nodes_where([](const Vec3&) { return true; });
}

double mean_separation_stress(const Specimen& specimen, const std::vector<int>& nodes) {
  double sum = 0;
  for (int node : nodes) sum += specimen.separation(node).stress;
  return sum / static_cast<double>(nodes.size());
}

void turn(BodyDescription& body, const Vec3& degrees) {
  body.rotation_degrees = degrees;
  const Vec3 radians = degrees * std::numbers::pi / 180;
  const Mat3 rotation = (Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
                         Eigen::AngleAxisd(radians.x(), Vec3::UnitX()))
                            .toRotationMatrix();
  for (Load& load : body.loads) load.traction = rotation * load.traction;
}

/// A figure that linear tets give at a resolution.
struct Step {
  int cells;
  double expected;
};

Scene pulled_bar(BoxPattern pattern, int cells, const Vec3& degrees) {
  Scene scene = validation_scene("bar_in_tension");
  turn(scene.bodies[0], degrees);
  auto& box = std::get<BoxShape>(scene.bodies[0].shape);
  box.pattern = pattern;
  box.element_size = Vec3::Constant(box.size.y() / cells);
  return scene;
}

/// n elements round a quadrant of the hole, and one through a thickness like them.
Scene pulled_plate(BoxPattern pattern, int cells) {
  Scene scene = validation_scene("plate_with_hole");
  auto& plate = std::get<PlateWithHoleShape>(scene.bodies[0].shape);
  plate.pattern = pattern;
  plate.size.z() = std::numbers::pi / 2 * plate.hole_radius / cells;
  plate.element_size = Vec2(plate.size.x() / cells, plate.size.z());
  return scene;
}

/// A disc with `core` cells on a side of its core, which takes 0.6 of the diameter.
Scene pressed_disc(BoxPattern pattern, int core) {
  Scene scene = validation_scene("brazilian_disc");
  auto& disc = std::get<DiscShape>(scene.bodies[0].shape);
  disc.pattern = pattern;
  disc.element_size.x() = 1.2 * disc.radius / core;
  return scene;
}

/// Three-point bending, n cells through the depth.
Scene bent_beam(BoxPattern pattern, int cells) {
  Scene scene = validation_scene("three_point_bending");
  auto& box = std::get<BoxShape>(scene.bodies[0].shape);
  box.pattern = pattern;
  box.element_size = Vec3::Constant(box.size.y() / cells);
  return scene;
}

/// 3PL/2bd² of the scene's beam and load [Pa].
double bending_stress(const Scene& scene) {
  const Vec3& size = std::get<BoxShape>(scene.bodies[0].shape).size;
  const double load = scene.bodies[0].loads[0].force.norm();
  return 3 * load * size.x() / (2 * size.z() * size.y() * size.y());
}

/// s in the middle of the bottom, half-way between bearing and load, over its closed form.
double far_field_fraction(const Specimen& specimen, const Scene& scene) {
  const Vec3& size = std::get<BoxShape>(scene.bodies[0].shape).size;
  const std::vector<int> nodes = specimen.nodes_where(
      [&](const Vec3& x) { return x.y() < -size.y() / 2 + 1e-9 && std::abs(std::abs(x.x()) - size.x() / 4) < 1e-9; });
  return mean_separation_stress(specimen, nodes) / (bending_stress(scene) / 2);
}

}  // namespace

std::vector<Row> bar_in_tension(Extent) {
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (int cells : {2, 4, 8})
      for (const Vec3& degrees : {Vec3(0, 0, 0), Vec3(20, 35, 50)}) {
        const Scene scene = pulled_bar(pattern, cells, degrees);
        const Vec3 axis = scene.bodies[0].loads[0].traction.normalized();
        const double stress = scene.bodies[0].loads[0].traction.norm();
        const double end = std::get<BoxShape>(scene.bodies[0].shape).size.x() / 2;
        Specimen specimen(scene);
        specimen.equilibrate();
        double separation_error = 0, stress_error = 0;
        for (int node : specimen.nodes_where([&](const Vec3& x) { return std::abs(x.dot(axis)) < end - 1e-9; }))
          separation_error = std::max(separation_error, std::abs(specimen.separation(node).stress / stress - 1));
        for (const Mat3& tet : specimen.stresses())
          stress_error = std::max(stress_error, (tet / stress - axis * axis.transpose()).norm());
        const MeshLabel mesh = mesh_label(pattern, cells);
        const std::string name = degrees.isZero() ? "" : "turned: ";
        rows.push_back(at_most(mesh, name + "\\|s / stress − 1\\|, worst node", 1e-5, separation_error));
        rows.push_back(at_most(mesh, name + "stress tensor, worst tet", 1e-5, stress_error));
      }
  return rows;
}

std::vector<Row> three_point_bending(Extent) {
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    double coarser_error = 0;
    for (int cells : {4, 8, 16}) {
      const Scene scene = bent_beam(pattern, cells);
      const Vec3& size = std::get<BoxShape>(scene.bodies[0].shape).size;
      Specimen specimen(scene);
      specimen.equilibrate();
      const MeshLabel mesh = mesh_label(pattern, cells);
      const Peak worst = peak(specimen, all_nodes(specimen));
      const Vec3 place = specimen.rest_position(worst.node);
      rows.push_back(
          at_most(mesh, "worst node: height above the bottom / depth", 0, (place.y() + size.y() / 2) / size.y()));
      rows.push_back(at_most(mesh, "worst node: distance from midspan / depth", 0.25, std::abs(place.x()) / size.y()));
      rows.push_back(at_least(mesh, "worst node: \\|n·x\\|", 0.988, std::abs(worst.separation.normal.x())));
      const double fraction = far_field_fraction(specimen, scene), error = std::abs(1 - fraction);
      if (cells > 4) rows.push_back(at_most(mesh, "quarter span: error over that at n/2", 0.6, error / coarser_error));
      coarser_error = error;
      if (cells < 16) continue;
      rows.push_back(near(mesh, "quarter span: s / (3PL/4bd²)", 1, fraction, 0.02));
      rows.push_back(
          near(mesh, "worst node: s / (3PL/2bd²)", 1, worst.separation.stress / bending_stress(scene), 0.03));
    }
  }
  return rows;
}

std::vector<Row> plate_with_hole(Extent extent) {
  constexpr double kClosedForm = 3.03;
  constexpr std::array<Step, 4> kSteps = {{{4, 2.46}, {8, 2.91}, {16, 3.06}, {32, 3.10}}};
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (const auto& [cells, expected] : kSteps) {
      if (cells > 16 && extent == Extent::test) continue;
      const Scene scene = pulled_plate(pattern, cells);
      Specimen specimen(scene);
      specimen.equilibrate();
      const Peak worst = peak(specimen, all_nodes(specimen));
      const double concentration = worst.separation.stress / scene.bodies[0].loads[0].traction.norm();
      const double radius = std::get<PlateWithHoleShape>(scene.bodies[0].shape).hole_radius;
      const MeshLabel mesh = mesh_label(pattern, cells);
      if (pattern == BoxPattern::five_tet) rows.push_back(near(mesh, "K_t", expected, concentration, 0.03));
      if (cells >= 16) rows.push_back(near(mesh, "K_t, closed form", kClosedForm, concentration, 0.08));
      rows.push_back(near(mesh, "worst node: \\|y\\| / radius", 1,
                          std::abs(specimen.rest_position(worst.node).y()) / radius, 1e-9));
      rows.push_back(at_least(mesh, "worst node: \\|n·x\\|", 0.988, std::abs(worst.separation.normal.x())));
    }
  return rows;
}

std::vector<Row> brazilian_disc(Extent) {
  struct DiscStep {
    int cells, core;  // across the diameter, and of these in the core, even so that a node lies in the middle
    double expected;
  };
  constexpr std::array<DiscStep, 3> kSteps = {{{8, 4, .90}, {14, 8, .97}, {28, 16, 1}}};
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (const auto& [cells, core, expected] : kSteps) {
      const Scene scene = pressed_disc(pattern, core);
      const auto& disc = std::get<DiscShape>(scene.bodies[0].shape);
      Specimen specimen(scene);
      specimen.equilibrate();
      const double load = scene.bodies[0].loads[0].force.norm();
      const double stress = load / (std::numbers::pi * disc.radius * disc.thickness);
      const Peak middle = peak(specimen, specimen.nodes_where([](const Vec3& x) { return x.head<2>().norm() < 1e-9; }));
      const MeshLabel mesh = mesh_label(pattern, cells);
      if (pattern == BoxPattern::five_tet || expected == 1)
        rows.push_back(near(mesh, "s in the middle / (2P/πDt)", expected, middle.separation.stress / stress, 0.03));
      rows.push_back(at_least(mesh, "\\|n·x\\| in the middle", 0.988, std::abs(middle.separation.normal.x())));
    }
  return rows;
}

}  // namespace griffith::validation
