// Nanoseconds per element of what every element does in every substep. "direct" is Eigen's closed-form eigensolver, the
// measure for tensile_part().

#include <benchmark/benchmark.h>

#include <vector>

#include "sim/elasticity/element.h"
#include "sim/elasticity/polar_decomposition.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/elasticity/stiffness.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

constexpr int kElements = 1024;

/// Turned elements under strains of the size `strain`.
struct Elements {
  std::vector<RestElement> rest_elements;
  std::vector<Corners> corners;
  std::vector<Mat3> gradients;
  std::vector<ElementState> states;
  ElasticLaw law{ElementModel::corotational, 4e9, 6e9};

  explicit Elements(double strain, ElementModel model = ElementModel::corotational) {
    law.model = model;
    testing::RandomValues random(1);
    while (rest_elements.size() < kElements) {
      Corners rest_corners;
      for (int i = 0; i < 4; ++i) rest_corners.col(i) = random.vector();
      if ((rest_corners.rightCols<3>().colwise() - rest_corners.col(0)).determinant() < 0.1) continue;
      const Mat3 gradient = random.rotation() * (Mat3::Identity() + random.matrix(strain));
      rest_elements.push_back(rest_element(rest_corners));
      corners.push_back(gradient * rest_corners);
      gradients.push_back(gradient);
      states.push_back(element_state(law, element_deformation(model, rest_elements.back(), corners.back())));
    }
  }
};

template <class Work>
void run(benchmark::State& state, Work work) {
  for (auto _ : state)
    for (int i = 0; i < kElements; ++i) benchmark::DoNotOptimize(work(i));
  state.counters["per element"] =
      benchmark::Counter(kElements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double strain(const benchmark::State& state) { return 1.0 / static_cast<double>(state.range(0)); }

void whole_state(benchmark::State& state, ElementModel model) {
  const Elements elements(strain(state), model);
  run(state, [&](int i) {
    return element_state(elements.law, element_deformation(model, elements.rest_elements[i], elements.corners[i]));
  });
}
BENCHMARK_CAPTURE(whole_state, corotational, ElementModel::corotational)->Arg(10000)->Arg(10);
BENCHMARK_CAPTURE(whole_state, green_strain, ElementModel::green_strain)->Arg(10000)->Arg(10);

void rotation(benchmark::State& state) {
  const Elements elements(strain(state));
  run(state, [&](int i) { return polar_rotation(elements.gradients[i]); });
}
BENCHMARK(rotation)->Arg(10000)->Arg(10);

void tensile(benchmark::State& state) {
  const Elements elements(1e-4);
  run(state, [&](int i) { return tensile_part(elements.states[i].stress); });
}
BENCHMARK(tensile);

void tensile_direct(benchmark::State& state) {
  const Elements elements(1e-4);
  run(state, [&](int i) -> Mat3 {
    const PrincipalValues principal = principal_values(elements.states[i].stress);
    return principal.directions * principal.values.cwiseMax(0).asDiagonal() * principal.directions.transpose();
  });
}
BENCHMARK(tensile_direct);

void stiffness(benchmark::State& state, ElementModel model) {
  const Elements elements(1e-4, model);
  run(state, [&](int i) { return stiffness_row(elements.law, elements.rest_elements[i], elements.states[i], 0); });
}
BENCHMARK_CAPTURE(stiffness, corotational, ElementModel::corotational);
BENCHMARK_CAPTURE(stiffness, green_strain, ElementModel::green_strain);

}  // namespace
}  // namespace griffith
