#include "tests/fuzz/small_scenes.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/box_mesh.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/fuzz/extent.h"
#include "tests/mesh/sample_files.h"
#include "tests/scene/random_scene.h"
#include "tests/splinters/cell_files.h"

namespace griffith::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBodies = 3, kMaxBursts = 2;

void coarsen_pattern(SplinterPattern& pattern, double extent) {
  if (auto* voronoi = std::get_if<VoronoiSplinters>(&pattern)) voronoi->size = extent / 2;
  if (auto* radial = std::get_if<RadialSplinters>(&pattern)) {
    radial->sectors = 5;
    radial->first_ring = extent / 4;
  }
  if (auto* bricks = std::get_if<BrickSplinters>(&pattern)) {
    bricks->mortar = std::min(bricks->mortar, extent / 10);
    bricks->size = Vec3::Constant(extent / 2);
  }
  if (auto* points = std::get_if<PointSplinters>(&pattern)) points->path = "points.xyz";
  if (auto* cells = std::get_if<CellSplinters>(&pattern)) cells->path = "cells.obj";
}

/// Starts where it hits the first body soon.
void bring_near(ProjectileBurst& burst, const BodyDescription& body) {
  burst.count = std::min(burst.count, 3);
  burst.start = std::min(burst.start, 0.02);
  if (burst.shape)
    if (auto* surface = std::get_if<SurfaceProjectile>(&*burst.shape)) surface->path = "box.off";
  burst.position = body.position - 0.8 * extent_of(body.shape).norm() * burst.direction.normalized();
}

Scene made_small(Scene scene) {
  if (scene.bodies.size() > kMaxBodies) scene.bodies.resize(kMaxBodies);
  if (scene.projectiles.size() > kMaxBursts) scene.projectiles.resize(kMaxBursts);
  std::erase_if(scene.probes, [&](const Probe& probe) {
    return std::ranges::none_of(scene.bodies, [&](const auto& body) { return body.name == probe.body; });
  });
  for (BodyDescription& body : scene.bodies) {
    coarsen(body.shape);
    if (body.splinters) coarsen_pattern(*body.splinters, extent_of(body.shape).maxCoeff());
  }
  if (!scene.bodies.empty())
    for (ProjectileBurst& burst : scene.projectiles) bring_near(burst, scene.bodies.front());
  return scene;
}

std::vector<Scene> shipped_scenes() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(GRIFFITH_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Scene> scenes;
  for (const fs::path& path : paths) scenes.push_back(read_scene(path));
  return scenes;
}

/// Far apart and of any size, as the table of fields allows.
std::vector<Scene> random_scenes(int count) {
  std::vector<Scene> scenes;
  for (int seed = 1; seed <= count; ++seed) scenes.push_back(Randomizer(seed, {"box.msh", "box.off"}).scene());
  return scenes;
}

/// Returns the number of waves across the shape's finest cell that a step of explicit integration has to resolve.
double substeps_of(const BodyDescription& body, const SimulationSettings& settings) {
  if (settings.integrator == Integrator::implicit) return 1;
  const Material& m = body.material;
  const double modulus = m.young_modulus * (1 - m.poisson_ratio) / ((1 + m.poisson_ratio) * (1 - 2 * m.poisson_ratio));
  const double speed = std::sqrt(modulus / m.density);
  return 1 + 5 * settings.time_step * speed / finest_edge_of(body.shape);
}

/// About how many splinters a pattern makes of a box.
double count_of(const SplinterPattern& pattern, const Vec3& extent) {
  const double largest = extent.maxCoeff();
  if (const auto* voronoi = std::get_if<VoronoiSplinters>(&pattern))
    return std::pow(1 + extent.norm() / voronoi->size, 3) / voronoi->elongation;
  if (const auto* radial = std::get_if<RadialSplinters>(&pattern))
    return radial->sectors * (1 + (radial->center.norm() + largest) / radial->first_ring);
  if (const auto* bricks = std::get_if<BrickSplinters>(&pattern))
    return (1 + extent.array() / (bricks->size.array() + bricks->mortar)).prod();
  return 1;
}

std::string contents(const TemporaryFolder& folder, const char* name) { return read_file(folder.path() / name); }

}  // namespace

std::vector<Json> small_scenes() {
  constexpr int kRandomScenes = 60;
  std::vector<Scene> scenes = shipped_scenes();
  for (Scene& scene : random_scenes(kRandomScenes)) scenes.push_back(std::move(scene));
  std::vector<Json> documents;
  for (const Scene& scene : scenes) documents.push_back(Json::parse(scene_to_json(made_small(scene))));
  return documents;
}

const std::map<std::string, std::string>& small_files() {
  static const std::map<std::string, std::string> kFiles = [] {
    std::map<std::string, std::string> files;
    for (const auto& sample : testing::sample_files(make_box(Vec3(1, 1, 1), Vec3(1, 1, 1), BoxPattern::five_tet)))
      if (sample.format == "gmsh 2 text") files["box.msh"] = sample.files.begin()->second;
    files["box.off"] =
        "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 6 5\n4 0 4 7 3\n";
    files["points.xyz"] = "x y z\n0.1 0.2 0.3\n-0.4 0.1 0.2\n0.3 -0.2 -0.4\n";
    const TemporaryFolder folder;
    testing::write_cells(folder.path() / "cells.obj", {testing::box_cell("a", Vec3(-3, -3, -3), Vec3(0.1, 3, 3)),
                                                       testing::box_cell("b", Vec3(0.1, -3, -3), Vec3(3, 3, 3))});
    files["cells.obj"] = contents(folder, "cells.obj");
    return files;
  }();
  return kFiles;
}

double work_of(const Scene& scene) {
  constexpr double kTetsPerCell = 6;
  double work = 0;
  for (const BodyDescription& body : scene.bodies) {
    work += kTetsPerCell * cells_of(body.shape) * substeps_of(body, scene.simulation);
    if (body.splinters) work += count_of(*body.splinters, extent_of(body.shape));
  }
  for (const ProjectileBurst& burst : scene.projectiles) work += burst.count;
  return work;
}

Scene made_quick(Scene scene) {
  SimulationSettings& settings = scene.simulation;
  settings.step_budget = std::min(settings.step_budget, 5.0);
  settings.max_solver_iterations = std::min(settings.max_solver_iterations, 400);
  settings.max_cracks_per_step = std::min(settings.max_cracks_per_step, 400);
  return scene;
}

}  // namespace griffith::fuzz
