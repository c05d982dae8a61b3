// What an implicit step of a wall of 2 × 2 m costs: building its system or patching it, assembling it and solving it.
// Arguments: cells across, cells through the thickness; 32 × 2 are about 10,000 tets, 52 × 4 about 54,000. CPU time of
// one thread.

#include <benchmark/benchmark.h>

#include "sim/core/parallel.h"
#include "tests/solver/cracked_wall.h"

namespace griffith {
namespace {

using testing::Damage;
using testing::ElasticBox;
using testing::Load;

constexpr ImplicitStep kStep{.dt = 1.0 / 120, .relative_residual = 1e-3};

ElasticBox wall(const benchmark::State& state, Damage damage = Damage::intact, double young_modulus = 30e9) {
  return testing::cracked_wall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), BoxPattern::five_tet,
                               damage, young_modulus, 1);
}

void count_tets(benchmark::State& state, const ElasticBox& body) {
  state.counters["per tet"] = benchmark::Counter(
      body.mesh.tet_count(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void build(benchmark::State& state) {
  const ThreadLimit one(1);
  ElasticBox body = wall(state);
  for (auto _ : state) benchmark::DoNotOptimize(body.system().nodes().size());
  count_tets(state, body);
}
BENCHMARK(build)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);

/// After one split at a random node.
void patch(benchmark::State& state) {
  const ThreadLimit one(1);
  ElasticBox body = wall(state);
  ElasticSystem system = body.system();
  testing::RandomValues random(1);
  std::vector<NodeId> nodes(body.mesh.node_count());
  for (auto _ : state) {
    state.PauseTiming();
    body.split(NodeId(random.index(body.mesh.node_count())), random.direction());
    nodes.resize(body.mesh.node_count());
    for (int i = 0; i < body.mesh.node_count(); ++i) nodes[i] = NodeId(i);
    state.ResumeTiming();
    system.patch(body.mesh, nodes, body.constraints, body.rows);
  }
  count_tets(state, body);
}
BENCHMARK(patch)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);

void assemble_rows(benchmark::State& state) {
  const ThreadLimit one(1);
  ElasticBox body = wall(state);
  ElementRows rows;
  for (int i = 0; i < body.mesh.node_count(); ++i) body.rows[i] = i;
  for (int i = 0; i < body.mesh.node_count(); ++i) rows.add(body.mesh, NodeId(i), body.rows);
  rows.allocate();
  for (auto _ : state) rows.assemble({1, 1e-4}, body.law(), body.rest_elements, body.states, body.masses);
  count_tets(state, body);
}
BENCHMARK(assemble_rows)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);

void assemble_with_preconditioner(benchmark::State& state) {
  const ThreadLimit one(1);
  ElasticBox body = wall(state);
  ElasticSystem system = body.system();
  for (auto _ : state) body.assemble(system, kStep);
  count_tets(state, body);
}
BENCHMARK(assemble_with_preconditioner)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);

void solve(benchmark::State& state, Damage damage, double young_modulus) {
  const ThreadLimit one(1);
  ElasticBox body = wall(state, damage, young_modulus);
  ElasticSystem system = body.system();
  body.assemble(system, kStep);
  int iterations = 0;
  for (auto _ : state) {
    testing::apply(body, Load::impact);
    iterations = body.solve(system, kStep).iterations;
  }
  state.counters["iterations"] = iterations;
  count_tets(state, body);
}
BENCHMARK_CAPTURE(solve, soft, Damage::intact, 1e6)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, stiff, Damage::intact, 4e11)->Args({32, 2})->Args({52, 4})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, cracked, Damage::half_cracked, 30e9)
    ->Args({32, 2})
    ->Args({52, 4})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace griffith
