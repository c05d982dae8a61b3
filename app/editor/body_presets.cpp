#include "app/editor/body_presets.h"

#include "app/editor/new_entry.h"
#include "app/editor/placed_surface.h"
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
  const Vec3 size(2.5, 2, 0.25);
  BodyDescription wall = block("brick wall", "brick", size, Vec3(0.25, 0.25, 0.125), Vec3(0, size.y() / 2, 0));
  // Masonry with its mortar: softer and weaker than a single brick, as in scenes/brick_wall.json.
  wall.material.young_modulus = 1e9;
  wall.material.tensile_strength = wall.material.fracture_toughness = 2.5e5;
  wall.supports = {{HalfSpaceRegion{Vec3(0, -size.y() / 2, 0), Vec3(0, -1, 0)}}};
  wall.splinters = BrickSplinters{Vec3(0.24, 0.065, 0.12), 0.01, Vec3(-1.245, -0.995, -0.125)};
  return {wall};
}

std::vector<BodyDescription> vase(const std::filesystem::path& surface) {
  SurfaceShape shape;
  shape.path = surface;
  shape.meshing.element_size = 0.15;
  shape.meshing.radius_edge_ratio = 4;
  shape.meshing.min_dihedral_angle = 0;
  BodyDescription body;
  body.name = "vase";
  body.shape = shape;
  body.elements = ElementOrder::quadratic;
  // As in scenes/vase_shot.json.
  if (const std::optional<Material> preset = find_material_preset("porcelain")) body.material = *preset;
  body.material.young_modulus = 2e10;
  body.material.density = 2000;
  body.material.tensile_strength = 1.2e7;
  body.material.fracture_toughness = 6e5;
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
