// What splinters cost: making 20,000 of them, following a crack that halves the body, and what a frame hands to the
// renderer. The argument is the number of splinters along an edge of the cube.

#include <benchmark/benchmark.h>

#include "app/draw_scene_from_frame.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/splinters.h"

namespace griffith {
namespace {

TetMesh cube() { return build_mesh(make_box(Vec3::Ones(), Vec3::Constant(0.1), BoxPattern::five_tet)); }

SplinterSet shards(const TetMesh& mesh, const benchmark::State& state) {
  VoronoiSplinters pattern;
  pattern.size = 1.0 / static_cast<double>(state.range(0));
  return make_splinters(mesh, make_cells(pattern, {Vec3(Vec3::Constant(-0.5)), Vec3(Vec3::Constant(0.5))}));
}

void make(benchmark::State& state) {
  const TetMesh mesh = cube();
  for (auto _ : state) benchmark::DoNotOptimize(shards(mesh, state).splinters.size());
}
BENCHMARK(make)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Cuts all faces in the plane x = 0, as if the cube broke in two.
std::vector<TetId> halve(TetMesh& mesh) {
  std::vector<TetId> changed;
  for (TetId tet(0); tet < mesh.tet_count(); ++tet.value)
    for (TetId& neighbour : mesh.neighbours[tet])
      if (neighbour.valid() && rest_centroid(mesh, tet).x() * rest_centroid(mesh, neighbour).x() < 0) {
        neighbour = TetId();
        changed.push_back(tet);
      }
  return changed;
}

void follow(benchmark::State& state) {
  TetMesh mesh = cube();
  const SplinterSet set = shards(mesh, state);
  const std::vector<TetId> changed = halve(mesh);
  const SplinterState intact = intact_state(set);
  for (auto _ : state) {
    state.PauseTiming();
    SplinterState after = intact;
    state.ResumeTiming();
    follow_cracks(set, mesh.neighbours, changed, after);
    benchmark::DoNotOptimize(after.open_walls.size());
  }
  state.counters["splinters"] = static_cast<double>(set.splinters.size());
}
BENCHMARK(follow)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond);

void hand_to_renderer(benchmark::State& state) {
  const TetMesh mesh = cube();
  const SplinterSet set = shards(mesh, state);
  const SplinterState intact = intact_state(set);
  Frame frame;
  frame.rest_positions = frame.positions = mesh.rest_positions;
  frame.tets = mesh.tets;
  frame.splinters = set.splinters;
  frame.splinter_parts = set.parts;
  frame.splinter_faces = set.faces;
  frame.splinter_corners = set.corners;
  frame.attached_parts = intact.attached;
  frame.open_walls = intact.open_walls;
  Scene scene;
  scene.bodies.resize(1);
  std::vector<BodyId> tet_bodies(mesh.tets.size(), BodyId(0));
  const std::vector<BodyView> bodies = {{BodyId(0), BodyId()}};
  const std::vector<Mat3> stresses(mesh.tets.size(), Mat3::Zero());
  const std::vector<Material> materials(1);
  frame.tet_bodies = tet_bodies;
  frame.bodies = bodies;
  frame.stresses = stresses;
  frame.materials = materials;
  frame.neighbours = mesh.neighbours;
  const std::vector<std::uint8_t> first_surface(mesh.tets.size(), 0);
  frame.first_surface = first_surface;
  const app::EmbeddedDisplay display = app::embedded_display(frame, scene);
  for (auto _ : state)
    benchmark::DoNotOptimize(app::draw_scene_from_frame(frame, display, scene, {}, {}).embedded.carriers.size());
  state.counters["splinters"] = static_cast<double>(set.splinters.size());
}
BENCHMARK(hand_to_renderer)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace griffith
