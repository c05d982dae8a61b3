#include <cmath>
#include <cstdio>
#include <numeric>

#include "tests/validation/specimen.h"

namespace griffith::validation {
namespace {

// Of a square section; Timoshenko (1921).
constexpr double kShearFactor = 5.0 / 6;

struct Beam {
  double length, inertia, area;  // [m], [m⁴], [m²]
  double young_modulus, shear;   // [Pa]
};

Beam beam_of(const Scene& scene) {
  const Vec3& size = std::get<BoxShape>(scene.bodies[0].shape).size;
  const Material& material = scene.bodies[0].material;
  return {size.x(), size.z() * std::pow(size.y(), 3) / 12, size.y() * size.z(), material.young_modulus,
          shear_modulus(material)};
}

double tip_load_deflection(const Scene& scene) {
  const Beam beam = beam_of(scene);
  const double load = scene.bodies[0].loads[0].traction.norm() * beam.area;
  return load * std::pow(beam.length, 3) / (3 * beam.young_modulus * beam.inertia) +
         load * beam.length / (kShearFactor * beam.shear * beam.area);
}

double gravity_deflection(const Scene& scene) {
  const Beam beam = beam_of(scene);
  const double load = scene.bodies[0].material.density * beam.area * scene.gravity.norm();
  return load * std::pow(beam.length, 4) / (8 * beam.young_modulus * beam.inertia) +
         load * std::pow(beam.length, 2) / (2 * kShearFactor * beam.shear * beam.area);
}

void cut(Scene& scene, BoxPattern pattern, int cells_through_thickness) {
  scene.bodies[0].elements = ElementOrder::linear;
  auto& box = std::get<BoxShape>(scene.bodies[0].shape);
  box.pattern = pattern;
  box.element_size = Vec3::Constant(box.size.y() / cells_through_thickness);
}

/// Returns the mean deflection of the end face [m].
double tip_deflection(const Scene& scene) {
  Specimen specimen(scene);
  specimen.equilibrate();
  const double end = beam_of(scene).length / 2;
  const std::vector<int> tip = specimen.nodes_where([&](const Vec3& x) { return x.x() > end - 1e-9; });
  const double sum = std::accumulate(tip.begin(), tip.end(), 0.0,
                                     [&](double total, int node) { return total - specimen.displacement(node).y(); });
  return sum / static_cast<double>(tip.size());
}

/// Nodes of a beam of ten cubes, n cells through its thickness.
double node_count(BoxPattern pattern, int n) {
  const double corners = (10.0 * n + 1) * (n + 1) * (n + 1);
  return pattern == BoxPattern::bcc ? corners + 10.0 * n * n * n : corners;
}

/// Returns the expected fraction for another mesh of a pattern: log(1 − fraction) is nearly linear in the logarithm of
/// the nodes.
double interpolated_fraction(const std::vector<int>& cells, const std::vector<double>& fractions, BoxPattern pattern,
                             double nodes) {
  std::size_t i = 1;
  while (i + 1 < cells.size() && node_count(pattern, cells[i]) < nodes) ++i;
  const double before = std::log(node_count(pattern, cells[i - 1])), after = std::log(node_count(pattern, cells[i]));
  const double t = (std::log(nodes) - before) / (after - before);
  return 1 - std::exp((1 - t) * std::log(1 - fractions[i - 1]) + t * std::log(1 - fractions[i]));
}

struct Expectation {
  BoxPattern pattern;
  std::array<double, 4> fractions;  // of Timoshenko's deflection at n = 1, 2, 4, 8
};

/// Kuhn and five-tet against the fractions that linear tets give; BCC, which has more nodes, against five-tet.
std::vector<Row> cantilever(const char* scene_name, double (*closed_form)(const Scene&), double tolerance) {
  constexpr std::array<Expectation, 2> kExpected = {
      {{BoxPattern::kuhn, {.22, .50, .79, .93}}, {BoxPattern::five_tet, {.35, .67, .89, .96}}}};
  const std::vector<int> cells = {1, 2, 4, 8};
  std::array<std::vector<double>, 3> fractions;
  for (BoxPattern pattern : kPatterns)
    for (int n : cells) {
      Scene scene = validation_scene(scene_name);
      cut(scene, pattern, n);
      fractions[static_cast<int>(pattern)].push_back(tip_deflection(scene) / closed_form(scene));
    }
  std::vector<Row> rows;
  for (const auto& [pattern, expected] : kExpected)
    for (std::size_t i = 0; i < cells.size(); ++i)
      rows.push_back(near(mesh_label(pattern, cells[i]), "fraction of the deflection", expected[i],
                          fractions[static_cast<int>(pattern)][i], tolerance));
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (BoxPattern other : {BoxPattern::kuhn, BoxPattern::five_tet}) {
      if (other == BoxPattern::five_tet && cells[i] < 4) continue;
      const double fraction = interpolated_fraction(cells, fractions[static_cast<int>(other)], other,
                                                    node_count(BoxPattern::bcc, cells[i]));
      rows.push_back(at_least(mesh_label(BoxPattern::bcc, cells[i]),
                              "fraction; " + mesh_label(other, 0).pattern + "'s with as many nodes", fraction,
                              fractions[static_cast<int>(BoxPattern::bcc)][i]));
    }
  for (BoxPattern pattern : kPatterns) {
    const std::vector<double>& own = fractions[static_cast<int>(pattern)];
    for (std::size_t i = 1; i < cells.size(); ++i)
      rows.push_back(at_most(mesh_label(pattern, cells[i]), "error over that at n/2", cells[i] < 4 ? 0.7 : 0.5,
                             (1 - own[i]) / (1 - own[i - 1])));
  }
  return rows;
}

}  // namespace

std::vector<Row> cantilever_tip_load(Extent) { return cantilever("cantilever_tip_load", tip_load_deflection, 0.03); }

std::vector<Row> cantilever_gravity(Extent) { return cantilever("cantilever_gravity", gravity_deflection, 0.014); }

std::vector<Row> locking(Extent) {
  constexpr int kCells = 4;
  std::vector<Row> rows;
  for (BoxPattern pattern : kPatterns) {
    double previous = 1;
    for (double poisson_ratio : {0.3, 0.4, 0.45, 0.49, 0.499}) {
      Scene scene = validation_scene("cantilever_tip_load");
      scene.bodies[0].material.poisson_ratio = poisson_ratio;
      cut(scene, pattern, kCells);
      const double fraction = tip_deflection(scene) / tip_load_deflection(scene);
      char quantity[64];
      std::snprintf(quantity, sizeof quantity, "fraction at ν = %.3g; at the ν before", poisson_ratio);
      rows.push_back(at_most(mesh_label(pattern, kCells), quantity, previous, fraction));
      previous = fraction;
    }
  }
  return rows;
}

}  // namespace griffith::validation
