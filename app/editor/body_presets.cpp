#include "app/editor/body_presets.h"

#include "app/editor/new_entry.h"
#include "app/editor/placed_surface.h"
#include "app/editor/starting_scene.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/scene_reader.h"
#include "ui/model/region_outline.h"
#include "ui/model/scene_entry.h"

namespace griffith::app {
namespace {

BodyDescription block(const char* name, const char* material, const Vec3& size, const Vec3& element_size,
                      const Vec3& position) {
  BodyDescription body;
  body.name = name;
  body.shape = BoxShape{size, element_size, BoxPattern::five_tet};
  body.position = position;
  if (const std::optional<Material> preset = find_material_preset(material)) body.material = *preset;
  return body;
}

}  // namespace

std::vector<BodyDescription> table() {
  constexpr double kHeight = 0.7, kTop = 0.01, kLeg = 0.06;
  std::vector<BodyDescription> bodies = {block("table top", "soda_lime_glass", Vec3(1.2, kTop, 0.7),
                                               Vec3(0.06, kTop, 0.07), Vec3(0, kHeight + kTop / 2, 0))};
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.25, 0.25})
      bodies.push_back(block("table leg", "wood_along_grain", Vec3(kLeg, kHeight, kLeg), Vec3(kLeg / 2, 0.07, kLeg / 2),
                             Vec3(x, kHeight / 2, z)));
  return bodies;
}

std::vector<BodyDescription> brick_wall() {
  BodyDescription wall = starting_scene().bodies.front();
  wall.name = "brick wall";
  return {wall};
}

std::vector<BodyDescription> vase(const std::filesystem::path& sample, const std::filesystem::path& folder) {
  BodyDescription body = read_scene(sample).bodies.front();
  auto& shape = std::get<SurfaceShape>(body.shape);
  shape.path = path_from_scene(sample.parent_path() / shape.path, folder);
  return {body};
}

std::vector<BodyDescription> placed(std::vector<BodyDescription> bodies, const Scene& scene, const Frame& frame) {
  constexpr double kRoom = 0.1;
  Eigen::AlignedBox3d box;
  for (const BodyDescription& body : bodies) box.extend(placed_box(body, scene.folder));
  const double ground = scene.ground ? scene.ground->height : 0;
  const double right = scene.bodies.empty() ? 0 : free_place(scene, frame, kRoom) - box.min().x();
  std::vector<BodyDescription> known = scene.bodies;
  for (BodyDescription& body : bodies) {
    body.position = ui::moved_place(body.position, Vec3(right, ground, 0));
    body.name = ui::free_name(known, body.name);
    known.push_back(body);
  }
  return bodies;
}

}  // namespace griffith::app
