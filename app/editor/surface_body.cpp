#include "app/editor/surface_body.h"

#include <cstdio>
#include <utility>

#include "app/editor/new_entry.h"
#include "app/picture/placed_tets.h"
#include "sim/meshing/mesh_quality.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene_paths.h"
#include "ui/model/scene_entry.h"

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

std::function<Scene(const Monitor&)> scene_with_surface(const ui::SurfaceRequest& request, Scene scene,
                                                        const Frame& frame) {
  constexpr double kRoom = 0.1;
  const double free_x = free_place(scene, frame, kRoom);
  return [scene = std::move(scene), shape = shape_of(request), free_x](const Monitor& monitor) {
    if (monitor.stage) monitor.stage("Reading the surface");
    BodyDescription body = standing_body(shape, scene, free_x, monitor);
    std::get<SurfaceShape>(body.shape).path = path_from_scene(shape.path, scene.folder);
    Scene extended = scene;
    extended.bodies.push_back(std::move(body));
    return extended;
  };
}

ui::WorkReport surface_report(const World& world, const Scene& scene, int body) {
  ui::WorkReport report{"Added the body \"" + scene.bodies[static_cast<std::size_t>(body)].name + "\"",
                        facts_of(mesh_quality(placed_tets(world.frame(), body).soup)),
                        {}};
  const std::string place = "#/bodies/" + std::to_string(body) + "/";
  for (const InputError& finding : world.findings())
    if (finding.where().starts_with(place)) report.warnings.push_back(finding.problem());
  return report;
}

}  // namespace griffith::app
