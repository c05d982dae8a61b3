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
double far_field_share(const Specimen& specimen, const Scene& scene) {
  const Vec3& size = std::get<BoxShape>(scene.bodies[0].shape).size;
  const std::vector<int> nodes = specimen.nodes_where([&](const Vec3& x) {
    return x.y() < -size.y() / 2 + 1e-9 && std::abs(std::abs(x.x()) - size.x() / 4) < 1e-9;
  });
  return mean_separation_stress(specimen, nodes) / (bending_stress(scene) / 2);
}

}  // namespace

std::vector<Row> bar_in_tension(Extent extent) {
  const std::vector<int> refinements = extent == Extent::table ? std::vector<int>{2, 4, 8} : std::vector<int>{2, 4};
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns)
    for (int cells : refinements)
      for (const Vec3& degrees : {Vec3(0, 0, 0), Vec3(20, 35, 50)}) {
        Scene scene = validation_scene("bar_in_tension");
        turn(scene.bodies[0], degrees);
        auto& box = std::get<BoxShape>(scene.bodies[0].shape);
        box.pattern = pattern;
        box.element_size = Vec3::Constant(box.size.y() / cells);
        const double stress = scene.bodies[0].loads[0].traction.norm();
        Specimen specimen(scene);
        specimen.equilibrate();
        const Vec3 axis = scene.bodies[0].loads[0].traction.normalized();
        double error = 0;
        for (int node : all_nodes(specimen)) {
          if (std::abs(specimen.rest_position(node).dot(axis)) > box.size.x() / 2 - 1e-9) continue;
          error = std::max(error, std::abs(specimen.separation(node).stress / stress - 1));
        }
        rows.push_back(at_most(mesh_label(pattern, cells),
                               degrees.isZero() ? "s / stress − 1, worst node" : "the same, bar turned", 1e-5, error));
      }
  return rows;
}

std::vector<Row> three_point_bending(Extent extent) {
  const std::vector<int> refinements = extent == Extent::table ? std::vector<int>{4, 8, 16} : std::vector<int>{4, 8};
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    std::vector<double> shares;
    for (int cells : refinements) {
      const Scene scene = bent_beam(pattern, cells);
      const auto& box = std::get<BoxShape>(scene.bodies[0].shape);
      Specimen specimen(scene);
      specimen.equilibrate();
      const MeshLabel mesh = mesh_label(pattern, cells);
      const Peak worst = peak(specimen, all_nodes(specimen));
      const Vec3 place = specimen.rest_position(worst.node);
      rows.push_back(at_most(mesh, "worst node: height above the bottom / depth", 0,
                             (place.y() + box.size.y() / 2) / box.size.y()));
      rows.push_back(at_most(mesh, "worst node: distance from midspan / depth", 0.5, std::abs(place.x()) / box.size.y()));
      rows.push_back(at_least(mesh, "worst node: |n·x|", 0.988, std::abs(worst.separation.normal.x())));
      shares.push_back(far_field_share(specimen, scene));
      rows.push_back(near(mesh, "worst s / (3PL/2bd²)", 1, worst.separation.stress / bending_stress(scene), 9));
      rows.push_back(near(mesh, "s at a quarter of the span / (3PL/4bd²)", 1, shares.back(), 9));
    }
  }
  return rows;
}

std::vector<Row> plate_with_hole(Extent extent) {
  struct Step {
    int cells;
    double expected;
  };
  constexpr std::array<Step, 4> kSteps = {{{4, 2.46}, {8, 2.91}, {16, 3.06}, {32, 3.10}}};
  std::vector<Row> rows;
  for (const auto& [cells, expected] : kSteps) {
    if (cells > 16 && extent == Extent::test) continue;
    for (BoxPattern pp : kPatterns) for (double tt : {.005, .02, .05}) {
    Scene scene = validation_scene("plate_with_hole");
    auto& plate = std::get<PlateWithHoleShape>(scene.bodies[0].shape);
    plate.pattern = pp; plate.size.z() = tt; for (auto& l : scene.bodies[0].loads) l.traction *= 1;
    plate.element_size.y() = tt;
    plate.element_size.x() = plate.size.x() / cells;
    Specimen specimen(scene);
    specimen.equilibrate();
    const Peak worst = peak(specimen, all_nodes(specimen));
    const Vec3 place = specimen.rest_position(worst.node);
    const MeshLabel mesh = mesh_label(plate.pattern, cells);
    rows.push_back(near(mesh, "K_t", expected, worst.separation.stress / scene.bodies[0].loads[0].traction.norm(), 0.05));
    std::printf("%d %d %g K %g  %g %g\n", cells, (int)pp, tt, worst.separation.stress / 1e6, place.x(), place.y()); }
#if 0
    rows.push_back(near(mesh, "worst node: |y| / radius", 1, std::abs(place.y()) / plate.hole_radius, 1e-9));
    rows.push_back(at_least(mesh, "worst node: |n·x|", 0.99, std::abs(worst.separation.normal.x())));
#endif
  }
  return rows;
}

std::vector<Row> brazilian_disc(Extent) {
  struct Step {
    int cells;
    double expected;
  };
  constexpr std::array<Step, 3> kSteps = {{{4, .67}, {8, .90}, {16, .97}}};
  std::vector<Row> rows;
  for (const auto& [cells, expected] : kSteps) {
    Scene scene = validation_scene("brazilian_disc");
    auto& disc = std::get<DiscShape>(scene.bodies[0].shape);
    disc.element_size.x() = 1.2 * disc.radius / cells;
    Specimen specimen(scene);
    specimen.equilibrate();
    const double load = scene.bodies[0].loads[0].force.norm();
    const double stress = load / (std::numbers::pi * disc.radius * disc.thickness);
    const Peak middle = peak(specimen, specimen.nodes_where([](const Vec3& x) { return x.head<2>().norm() < 1e-9; }));
    const MeshLabel mesh = mesh_label(disc.pattern, cells);
    rows.push_back(near(mesh, "s in the middle / (2P/πDt)", expected, middle.separation.stress / stress, 0.05));
    rows.push_back(at_least(mesh, "|n·x| in the middle", 0.99, std::abs(middle.separation.normal.x())));
  }
  return rows;
}

}  // namespace griffith::validation
