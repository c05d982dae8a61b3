#include <algorithm>
#include <cstdio>

#include "app/editor/editor.h"
#include "app/editor/new_body.h"
#include "app/picture/placed_tets.h"
#include "app/shared/scene_world.h"
#include "sim/meshing/mesh_quality.h"
#include "sim/meshing/surface.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

SurfaceShape shape_of(const ui::SurfaceRequest& request) {
  if (request.path[0] == '\0') throw InputError("the surface", "has no file", "type its path in the dialog");
  SurfaceShape shape;
  shape.path = fs::absolute(request.path.data());
  shape.scale = request.scale;
  shape.meshing.method = request.method;
  if (!request.automatic_size) shape.meshing.element_size = request.element_size;
  return shape;
}

/// Returns a body on the ground next to the others.
BodyDescription standing_body(const SurfaceShape& shape, const Scene& scene, double free_x, const Monitor& monitor) {
  const Eigen::AlignedBox3d box = bounds(read_surface(shape.path, shape.scale, monitor));
  BodyDescription body;
  body.name = ui::free_name(scene.bodies, shape.path.stem().string());
  body.shape = shape;
  const double x = scene.bodies.empty() ? -box.center().x() : free_x - box.min().x();
  body.position = Vec3(x, (scene.ground ? scene.ground->height : 0) - box.min().y(), -box.center().z());
  return body;
}

/// Makes a file's path relative to the scene's folder, if it has one.
void make_relative(BodyDescription& body, const fs::path& folder) {
  if (folder.empty()) return;
  fs::path& path = std::get<SurfaceShape>(body.shape).path;
  path = path.lexically_proximate(fs::absolute(folder).lexically_normal());
}

std::string formatted(const char* format, auto... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::vector<std::string> facts_of(const MeshQuality& quality) {
  return {formatted("%d tetrahedra, %d nodes, %.4g m³", quality.tets, quality.nodes, quality.volume),
          formatted("edges from %.3g to %.3g m, mean %.3g m", quality.shortest_edge, quality.longest_edge,
                    quality.mean_edge),
          formatted("angles between faces from %.1f° to %.1f°", quality.min_dihedral, quality.max_dihedral),
          formatted("aspect ratio mean %.2f, worst %.1f", quality.mean_aspect_ratio, quality.worst_aspect_ratio)};
}

}  // namespace

void Editor::add_surface() {
  state_.running = false;
  const double room = 0.1;
  auto make_scene = [scene = history_.scene(), shape = shape_of(state_.surface),
                     free_x = free_place(history_.scene(), world().frame(), room)](const Monitor& monitor) mutable {
    if (monitor.stage) monitor.stage("Reading the surface");
    BodyDescription body = standing_body(shape, scene, free_x, monitor);
    make_relative(body, scene.folder);
    scene.bodies.push_back(std::move(body));
    return scene;
  };
  loader_.start(LoadReason::add_body, std::move(make_scene), path_, max_tets());
}

void Editor::report_surface() {
  const int index = state_.selected_body;
  const MeshQuality quality = mesh_quality(placed_tets(world().frame(), index).soup);
  ui::WorkReport report{"Added the body \"" + history_.scene().bodies[static_cast<std::size_t>(index)].name + "\"",
                        facts_of(quality),
                        {}};
  const std::string place = "#/bodies/" + std::to_string(index) + "/";
  for (const InputError& finding : world().findings())
    if (finding.where().starts_with(place)) report.warnings.push_back(finding.problem());
  log(ui::LogLevel::info, report.title + ": " + report.facts.front());
  for (const std::string& warning : report.warnings) log(ui::LogLevel::warning, warning);
  state_.report = std::move(report);
  frame_all();
}

}  // namespace griffith::app
