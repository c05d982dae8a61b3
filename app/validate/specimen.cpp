#include "app/validate/specimen.h"

#include <cmath>
#include <limits>

#include "app/shared/flip_search.h"

namespace griffith::app {

Scene empty_laboratory() {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.step_budget = 1e6;  // nothing is scaled
  return scene;
}

Material laboratory_material(const char* key) { return find_material_preset(key).value(); }

BodyDescription& add_body(SpecimenScene& specimen, const TetSoup& mesh, const Material& material) {
  const std::string name = "body " + std::to_string(specimen.scene.bodies.size());
  specimen.meshes[name] = mesh;
  BodyDescription& body = specimen.scene.bodies.emplace_back();
  body.name = name;
  body.shape = MeshFileShape{name};
  body.material = material;
  return body;
}

HalfSpaceRegion end_region(const Vec3& axis, double distance) { return {distance * axis, axis}; }

Support sliding_support(const Region& region, const Vec3& normal) {
  Support support;
  support.region = region;
  support.kind = SupportKind::sliding;
  support.normal = normal;
  support.can_tear = false;
  return support;
}

std::vector<Support> plane_strain(double thickness) {
  std::vector<Support> supports;
  for (const double side : {-1.0, 1.0})
    supports.push_back(sliding_support(end_region(side * Vec3::UnitZ(), thickness / 2), Vec3::UnitZ()));
  return supports;
}

Load traction_on(const Region& region, const Vec3& traction) {
  Load load;
  load.kind = LoadKind::traction;
  load.region = region;
  load.traction = traction;
  return load;
}

double lowest_breaking(double low, double high, double tolerance, const std::function<bool(double)>& breaks) {
  FlipSearch search;
  search.geometric = true;
  search.tolerance = tolerance;
  const auto tried = search_flips(search, {low, high}, states_of(breaks));
  const std::vector<Bracket> flips = flips_among(tried);
  if (flips.empty() || tried.at(low)[0]) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(flips[0].below * flips[0].above);
}

SpecimenScene loaded(SpecimenScene specimen, double factor) {
  for (BodyDescription& body : specimen.scene.bodies)
    for (Load& load : body.loads) {
      load.force *= factor;
      load.traction *= factor;
      load.pressure *= factor;
      load.acceleration *= factor;
    }
  return specimen;
}

bool fails_statically(const SpecimenScene& specimen, double area) {
  constexpr int kRounds = 100;              // a round opens some nodes, so a front may need many
  const int equilibria = area > 0 ? 8 : 1;  // the first one shows whether anything cracks
  Scene scene = specimen.scene;
  scene.analysis = Analysis::static_;
  scene.simulation.impact_substeps = equilibria;
  World world(scene, specimen.meshes);
  for (int round = 0; round < kRounds; ++round) {
    world.step();
    if (world.frame().energy.crack_area > area) return true;
    if (world.frame().report.cracks == 0) return false;
  }
  return false;
}

double rayleigh_wave_speed(const Material& material) {
  return std::sqrt(shear_modulus(material) / material.density) * (0.862 + 1.14 * material.poisson_ratio) /
         (1 + material.poisson_ratio);
}

}  // namespace griffith::app
