// What a microstep of a block of five-tet cells costs a tet: forces of the elements and motion of the nodes. Arguments:
// tets, threads. Real time, since threads share it; on one thread that is CPU time on a quiet machine.

#include <benchmark/benchmark.h>

#include <cmath>

#include "sim/core/parallel.h"
#include "sim/explicit/explicit_bodies.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"

namespace griffith::explicit_dynamics {
namespace {

/// A block of concrete that vibrates a little.
ExplicitBodies vibrating_block(int tets, ElementModel model) {
  Material material = *find_material_preset("concrete");
  material.element_model = model;
  const double cells = std::cbrt(tets / 5.0);
  const TetMesh mesh = build_mesh(make_box(Vec3::Ones(), Vec3::Constant(1 / std::round(cells)), BoxPattern::five_tet));
  ExplicitBodies bodies;
  for (const Vec3& rest : mesh.rest_positions)
    bodies.add_node({rest, Vec3::Zero(), 0.1 * Vec3(std::sin(9 * rest.x()), std::cos(7 * rest.y()), rest.z()),
                     Vec3::Zero(), material.density / static_cast<double>(mesh.rest_positions.size())});
  std::vector<std::array<int, 4>> corners;
  std::vector<RestElement> rest_elements;
  for (const auto& tet : mesh.tets) {
    Corners places;
    for (int i = 0; i < 4; ++i) places.col(i) = mesh.rest_positions[tet[i]];
    rest_elements.push_back(rest_element(places));
    corners.push_back({tet[0].index(), tet[1].index(), tet[2].index(), tet[3].index()});
  }
  const std::vector<Mat3> offsets(corners.size(), Mat3::Zero());
  bodies.add_body(elastic_law(material), material.density, corners, rest_elements, offsets);
  bodies.finish();
  bodies.set_step(bodies.stable_step(0.5));
  return bodies;
}

void microstep(benchmark::State& state, ElementModel model) {
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  ExplicitBodies bodies = vibrating_block(static_cast<int>(state.range(0)), model);
  std::vector<int> flagged;
  for (auto _ : state) {
    bodies.compute_forces();
    bodies.advance(1, flagged);
  }
  state.counters["per tet"] = benchmark::Counter(
      bodies.tet_slots(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(microstep, green_strain, ElementModel::green_strain)
    ->ArgsProduct({{430, 2000, 10000, 50000}, {1, 2}})
    ->UseRealTime();
BENCHMARK_CAPTURE(microstep, corotational, ElementModel::corotational)
    ->ArgsProduct({{430, 2000, 10000, 50000}, {1, 2}})
    ->UseRealTime();

}  // namespace
}  // namespace griffith::explicit_dynamics
