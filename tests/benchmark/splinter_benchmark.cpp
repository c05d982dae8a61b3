// What splinters cost: making 20,000 of them, following a crack that halves the body, and what a frame hands to the
// renderer. The argument is the number of splinters along an edge of the cube.

#include <benchmark/benchmark.h>

#include "app/picture/draw_scene_from_frame.h"
#include "renderer/egl_context.h"
#include "renderer/embedded_pass.h"
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
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
    for (TetId& neighbor : mesh.neighbors[tet])
      if (neighbor.valid() && rest_centroid(mesh, tet).x() * rest_centroid(mesh, neighbor).x() < 0) {
        neighbor = TetId();
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
    follow_cracks(set, mesh.neighbors, changed, after);
    benchmark::DoNotOptimize(after.open_walls.size());
  }
  state.counters["splinters"] = static_cast<double>(set.splinters.size());
}
BENCHMARK(follow)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond);

/// A cube of splinters, halved: what a frame hands out about it.
class HalvedCube {
 public:
  explicit HalvedCube(const benchmark::State& state) : mesh_(cube()), set_(shards(mesh_, state)) {
    state_ = intact_state(set_);
    follow_cracks(set_, mesh_.neighbors, halve(mesh_), state_);
    bodies_.resize(1);
    bodies_[0].id = BodyId(0);
    tet_bodies_.assign(mesh_.tets.size(), BodyId(0));
    stresses_.assign(mesh_.tets.size(), Mat3::Zero());
    first_surface_.assign(mesh_.tets.size(), 0);
    scene_.bodies.resize(1);
    scene_.view.quantity = "material";
  }

  Frame frame() const {
    Frame frame;
    frame.nodes.rest_positions = frame.nodes.positions = mesh_.rest_positions;
    frame.elements.tets = mesh_.tets;
    frame.elements.neighbors = mesh_.neighbors;
    frame.elements.bodies = tet_bodies_;
    frame.bodies = bodies_;
    frame.elements.stresses = stresses_;
    frame.materials = materials_;
    frame.elements.first_surface = first_surface_;
    frame.splinters.splinters = set_.splinters;
    frame.splinters.parts = set_.parts;
    frame.splinters.faces = set_.faces;
    frame.splinters.corners = set_.corners;
    frame.splinters.attached = state_.attached;
    frame.splinters.open_walls = state_.open_walls;
    return frame;
  }
  const Scene& scene() const { return scene_; }

 private:
  TetMesh mesh_;
  SplinterSet set_;
  SplinterState state_;
  std::vector<BodyView> bodies_;
  std::vector<BodyId> tet_bodies_;
  std::vector<Mat3> stresses_;
  std::vector<Material> materials_{1};
  std::vector<std::uint8_t> first_surface_;
  Scene scene_;
};

void count(benchmark::State& state, const Frame& frame) {
  state.counters["splinters"] = static_cast<double>(frame.splinters.splinters.size());
  state.counters["parts"] = static_cast<double>(frame.splinters.parts.size());
  state.counters["faces"] = static_cast<double>(frame.splinters.faces.size());
  state.counters["open"] = static_cast<double>(frame.splinters.open_walls.size());
}

void hand_to_renderer(benchmark::State& state) {
  const HalvedCube halved(state);
  const Frame frame = halved.frame();
  const app::EmbeddedDisplay display = app::embedded_display(frame, halved.scene());
  for (auto _ : state) {
    const auto picture = app::draw_scene_from_frame(frame, display, halved.scene(), halved.scene().view, {});
    benchmark::DoNotOptimize(picture.embedded.carriers.size());
  }
  count(state, frame);
}
BENCHMARK(hand_to_renderer)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond);

/// Measures the upload of a frame without new open walls.
void upload(benchmark::State& state) {
  const render::EglContext context(std::nullopt);
  render::EmbeddedPass pass;
  const HalvedCube halved(state);
  const Frame frame = halved.frame();
  const app::EmbeddedDisplay display = app::embedded_display(frame, halved.scene());
  const auto picture = app::draw_scene_from_frame(frame, display, halved.scene(), halved.scene().view, {});
  pass.upload(picture.embedded);
  for (auto _ : state) pass.upload(picture.embedded);
  count(state, frame);
}
BENCHMARK(upload)->Arg(10)->Arg(27)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace griffith
