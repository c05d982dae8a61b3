// What an implicit step of a wall of 2 × 2 m costs: building its system or patching it, assembling it and solving it.
// Arguments: cells across, cells through the thickness; 32 × 2 are about 10,000 tets, 52 × 4 about 54,000. CPU time of
// one thread. And the same for plates of quadratic elements, with the contacts of such a plate.

#include <benchmark/benchmark.h>

#include "sim/core/parallel.h"
#include "sim/solver/conjugate_gradient.h"
#include "sim/solver/contact_problem.h"
#include "tests/random_values.h"
#include "tests/solver/cracked_wall.h"
#include "tests/solver/quadratic_strip.h"

namespace griffith {
namespace {

using testing::Damage;
using testing::ElasticBox;
using testing::Load;
using testing::QuadraticStrip;

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

/// Contacts of the lowest nodes of a strip with the ground.
std::vector<FrictionContact> contacts_below(const QuadraticStrip& strip, int count) {
  std::vector<FrictionContact> contacts;
  for (int row = 0; row < strip.system->rows() && static_cast<int>(contacts.size()) < count; ++row) {
    if (row >= static_cast<int>(strip.system->nodes().size())) break;
    if (strip.body.positions[strip.system->nodes()[row]].y() > 0) continue;
    FrictionContact& contact = contacts.emplace_back();
    contact.a.body = 0;
    contact.a.deformable = true;
    contact.a.point = {{row, -1, -1}, {Mat3::Identity(), Mat3::Zero(), Mat3::Zero()}};
    contact.axes << Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX();
    contact.friction = 0.4;
    contact.free_velocity = Vec3(-0.1, 0.3, 0.1);
  }
  return contacts;
}

/// Plates 6 mm thick of quadratic elements of this many across, in an implicit step.
QuadraticStrip plate(const benchmark::State& state) {
  const double cell = 1.0 / static_cast<double>(state.range(0));
  return QuadraticStrip(false, Vec3(1, 0.006, 1), Vec3(cell, 0.006, cell));
}

void factor_quadratic(benchmark::State& state) {
  const ThreadLimit one(1);
  QuadraticStrip strip = plate(state);
  double dt = 1e-2;
  for (auto _ : state) {
    dt = dt > 9e-3 ? 5e-3 : 1e-2;  // so that factors do not hold
    strip.assemble(dt);
  }
  count_tets(state, strip.body);
  state.counters["bytes per tet"] = static_cast<double>(strip.system->memory()) / strip.body.mesh.tet_count();
}
BENCHMARK(factor_quadratic)->Arg(13)->Arg(26)->Arg(52)->Unit(benchmark::kMillisecond);

void solve_quadratic(benchmark::State& state) {
  const ThreadLimit one(1);
  QuadraticStrip strip = plate(state);
  strip.assemble();
  testing::RandomValues random(1);
  NodeVectors b(3, strip.system->rows());
  for (Eigen::Index i = 0; i < b.cols(); ++i) b.col(i) = random.vector();
  for (auto _ : state) {
    NodeVectors x = NodeVectors::Zero(3, b.cols());
    conjugate_gradient(strip.system->matrix(), {strip.system->preconditioner(), strip.system->factors()}, b, x, 1e-4,
                       b.norm(), 100);
  }
  count_tets(state, strip.body);
}
BENCHMARK(solve_quadratic)->Arg(13)->Arg(26)->Arg(52)->Unit(benchmark::kMillisecond);

/// Arguments: elements across, contacts.
void solve_contacts_of_quadratic(benchmark::State& state) {
  const ThreadLimit one(1);
  QuadraticStrip strip = plate(state);
  strip.assemble();
  const DeformableInertia body{.matrix = &strip.system->matrix(),
                               .preconditioner = &strip.system->preconditioner(),
                               .whole = strip.whole(),
                               .factors = strip.system->factors()};
  const std::vector<FrictionContact> apart = contacts_below(strip, static_cast<int>(state.range(1)));
  ContactSolveReport report;
  for (auto _ : state) {
    std::vector<FrictionContact> contacts = apart;
    std::vector<NodeVectors> changes;
    report = solve_contact_problem({&body, 1}, {}, contacts, {}, changes);
  }
  state.counters["Newton steps"] = report.newton_steps;
}
BENCHMARK(solve_contacts_of_quadratic)->Args({13, 8})->Args({13, 40})->Args({26, 40})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace griffith
