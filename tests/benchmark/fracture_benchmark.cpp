// What opening the mesh at one node costs, in a wall of 2 × 2 m: along faces, and with the tets cut along the plane.
// Argument: cells across; 32 are about 10,000 tets, 52 about 54,000. It depends on the node's star, not on the mesh.

#include <benchmark/benchmark.h>

#include "sim/fracture/remesh.h"
#include "sim/fracture/split.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

constexpr int kCracks = 100;  // on one wall: each cut grows it a little

TetMesh wall(const benchmark::State& state) {
  const double size = 2.0 / static_cast<double>(state.range(0));
  return build_mesh(make_box(Vec3(2, 2, 4 * size), Vec3::Constant(size), BoxPattern::five_tet));
}

template <class Crack>
void crack_walls(benchmark::State& state, Crack crack) {
  const TetMesh intact = wall(state);
  for (auto _ : state) {
    state.PauseTiming();
    TetMesh mesh = intact;
    testing::RandomValues random(1);
    state.ResumeTiming();
    for (int i = 0; i < kCracks; ++i) crack(mesh, NodeId(random.index(intact.node_count())), random.direction());
  }
  state.counters["per crack"] =
      benchmark::Counter(kCracks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void split_along_faces(benchmark::State& state) {
  crack_walls(state, [](TetMesh& mesh, NodeId node, const Vec3& normal) {
    benchmark::DoNotOptimize(split_node(mesh, mesh.rest_positions, node, normal));
  });
}
BENCHMARK(split_along_faces)->Arg(32)->Arg(52)->Unit(benchmark::kMicrosecond);

void cut_along_the_plane(benchmark::State& state) {
  std::vector<std::uint8_t> at_crack_front;
  crack_walls(state, [&](TetMesh& mesh, NodeId node, const Vec3& normal) {
    at_crack_front.resize(2 * mesh.rest_positions.size(), 0);
    const StarCut cut = cut_star(mesh, mesh.rest_positions, at_crack_front, node, normal, {});
    benchmark::DoNotOptimize(split_node(mesh, node, cut.above));
  });
}
BENCHMARK(cut_along_the_plane)->Arg(32)->Arg(52)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace griffith
