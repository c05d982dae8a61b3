#include <cmath>
#include <map>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/shapes.h"

namespace griffith::app {
namespace {

// Uniform states of stress in soda-lime glass (Kamarei et al. 2026). Its strength surface is that of Drucker and
// Prager through both strengths: √J₂ + γ₁ I₁ = γ₀.
constexpr double kGlassTension = 40e6, kGlassCompression = 1000e6;  // [Pa]

struct StrengthSurface {
  double gamma0 = 2 * kGlassCompression * kGlassTension / (std::sqrt(3) * (kGlassCompression + kGlassTension));
  double gamma1 = (kGlassCompression - kGlassTension) / (std::sqrt(3) * (kGlassCompression + kGlassTension));

  double shear() const { return gamma0; }
  double equibiaxial() const { return gamma0 / (1 / std::sqrt(3) + 2 * gamma1); }
  double hydrostatic() const { return gamma0 / (3 * gamma1); }
};

Material strength_glass() {
  Material glass = laboratory_material("soda_lime_glass");
  glass.tensile_strength = kGlassTension;
  glass.compressive_strength = kGlassCompression;
  return glass;
}

/// Returns a free block under equal tractions [Pa] along its first `axes` axes.
SpecimenScene pulled_block(int axes, double traction, BoxPattern pattern, int cells) {
  const Vec3 size(0.1, 0.1, axes == 2 ? 0.1 / cells : 0.1);
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription& block = add_body(specimen, make_box(size, Vec3::Constant(0.1 / cells), pattern), strength_glass());
  for (int axis = 0; axis < axes; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 outward = side * Vec3::Unit(axis);
      block.loads.push_back(traction_on(end_region(outward, size[axis] / 2), traction * outward));
    }
  return specimen;
}

/// Returns the load factor at which the first node separates.
double onset(const SpecimenScene& specimen) {
  return lowest_breaking(0.25, 4, 0.005, [&](double load) { return fails_statically(loaded(specimen, load), 0); });
}

/// Returns readings of the stress at the onset over `expected` [Pa] for all patterns.
std::vector<Reading> block_readings(int axes, double expected, double tolerance, int mesh) {
  std::vector<Reading> readings;
  for (const auto& [name, pattern] : kNamedPatterns)
    readings.push_back({"stress at onset / strength", name, around(1, tolerance),
                        onset(pulled_block(axes, expected, pattern, 2 << mesh))});
  return readings;
}

// ---- torsion

constexpr double kBarRadius = 0.01, kBarLength = 0.03;  // [m], about z

/// Returns a third of the area of its faces on the plane z = `height` for each node there [m²].
std::map<int, double> end_areas(const TetSoup& bar, double height) {
  std::map<int, double> areas;
  for (const std::array<int, 4>& tet : bar.tets)
    for (const std::array<int, 3>& face : kTetFaces) {
      const Vec3 &a = bar.points[tet[face[0]]], &b = bar.points[tet[face[1]]], &c = bar.points[tet[face[2]]];
      if (std::max({std::abs(a.z() - height), std::abs(b.z() - height), std::abs(c.z() - height)}) > 1e-9) continue;
      for (const int corner : face) areas[tet[corner]] += (b - a).cross(c - a).norm() / 6;
    }
  return areas;
}

/// Returns a free bar with the shear stress of a torque, `stress` r/R, on the nodes of both ends.
SpecimenScene twisted_bar(double stress, BoxPattern pattern, int cells) {
  const double size = 2 * kBarRadius / cells;
  const TetSoup mesh = make_cylinder(kBarRadius, kBarLength, Vec2::Constant(size), pattern);
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription& bar = add_body(specimen, mesh, strength_glass());
  for (const double side : {-1.0, 1.0})
    for (const auto& [node, area] : end_areas(mesh, side * kBarLength / 2)) {
      const Vec3& point = mesh.points[node];
      Load twist;
      twist.region = NodeListRegion{{node}};
      twist.force = side * area * stress / kBarRadius * Vec3(-point.y(), point.x(), 0);
      bar.loads.push_back(twist);
    }
  return specimen;
}

std::vector<Reading> run_torsion(int mesh) {
  std::vector<Reading> readings;
  for (const auto& [name, pattern] : {kNamedPatterns[0], kNamedPatterns[1]})
    readings.push_back({"stress at onset / strength", name, around(1, 0.1),
                        onset(twisted_bar(StrengthSurface().shear(), pattern, 6 << mesh))});
  return readings;
}

constexpr const char* kNineCircles = "Kamarei, Zeng, Dolbow & Lopez-Pamies 2026";

}  // namespace

Experiment uniaxial_tension() {
  return {.key = "uniaxial_tension",
          .title = "Uniaxial tension of glass",
          .source = kNineCircles,
          .measured =
              "A block of soda-lime glass, strengths 40 MPa in tension and 1000 MPa in compression, under uniform "
              "tractions on two opposite sides. Measured is "
              "the traction at which the first node separates, over σ_t.",
          .acceptance = "σ_t ± 2 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = L/2", "h = L/4", "h = L/8"},
          .quick = true,
          .run = [](int mesh) { return block_readings(1, kGlassTension, 0.02, mesh); }};
}

Experiment biaxial_tension() {
  return {.key = "biaxial_tension",
          .title = "Equibiaxial tension of glass",
          .source = kNineCircles,
          .measured =
              "A thin block of soda-lime glass, strengths 40 MPa in tension and 1000 MPa in compression, under equal "
              "tractions on four sides. Measured is the traction at the first separation, over 27.0 MPa: the "
              "equibiaxial strength of Drucker and Prager's surface through both.",
          .acceptance = "27.0 MPa ± 10 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = L/2", "h = L/4", "h = L/8"},
          .quick = true,
          .run = [](int mesh) { return block_readings(2, StrengthSurface().equibiaxial(), 0.1, mesh); }};
}

Experiment hydrostatic_tension() {
  return {.key = "hydrostatic_tension",
          .title = "Hydrostatic tension of glass",
          .source = kNineCircles,
          .measured =
              "A block of the same glass under equal tractions on all six sides. Measured is the traction at the "
              "first separation, over the hydrostatic strength of 27.8 MPa.",
          .acceptance = "27.8 MPa ± 10 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = L/2", "h = L/4", "h = L/8"},
          .quick = true,
          .run = [](int mesh) { return block_readings(3, StrengthSurface().hydrostatic(), 0.1, mesh); }};
}

Experiment torsion() {
  return {.key = "torsion",
          .title = "Torsion of a bar of glass",
          .source = kNineCircles,
          .measured =
              "A round bar of the same glass, 20 mm thick and 30 mm long, with the shear stress of a torque T on its "
              "ends. Measured is the stress 2T/(πR³) at the first separation, over the shear strength of 44.4 MPa.",
          .acceptance = "44.4 MPa ± 10 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = D/6", "h = D/12", "h = D/24"},
          .run = run_torsion};
}

}  // namespace griffith::app
