#include "app/editor/new_body.h"

#include <algorithm>
#include <cassert>

#include "sim/scene/body_pose.h"
#include "sim/world/setup/shape_mesh.h"
#include "ui/model/scene_entry.h"

namespace griffith::app {
namespace {

using ui::CommandId;

struct Kind {
  const char* name;
  const char* material;
  Shape shape;
  Vec3 rotation_degrees = Vec3::Zero();
};

Kind kind_of(CommandId command) {
  switch (command) {
    case CommandId::add_box:
      return {"box", "concrete", BoxShape{Vec3(0.5, 0.5, 0.5), Vec3::Constant(0.125), BoxPattern::five_tet}};
    case CommandId::add_plate:
      return {"plate", "soda_lime_glass", BoxShape{Vec3(0.8, 0.02, 0.8), Vec3(0.08, 0.01, 0.08), BoxPattern::five_tet}};
    case CommandId::add_pane:
      return {"pane", "soda_lime_glass", BoxShape{Vec3(0.8, 0.8, 0.02), Vec3(0.08, 0.08, 0.01), BoxPattern::five_tet}};
    case CommandId::add_cylinder:
      return {"cylinder", "concrete", CylinderShape{0.1, 0.6, Vec2(0.05, 0.06), BoxPattern::five_tet}, Vec3(90, 0, 0)};
    case CommandId::add_sphere:
      return {"sphere", "concrete", SphereShape{0.2, 0.08, BoxPattern::five_tet}};
    case CommandId::add_beam:
      return {"beam", "concrete",
              NotchedBeamShape{Vec3(1.2, 0.2, 0.2), 0.05, Vec3::Constant(0.05), BoxPattern::five_tet}};
    default:
      assert(false && "adds no body");
      return {"box", "concrete", BoxShape{}};
  }
}

/// Returns the bounding box of a body in its placement [m].
Eigen::AlignedBox3d placed_bounds(const BodyDescription& body, const Scene& scene) {
  const Pose pose = pose_of(body);
  Eigen::AlignedBox3d box;
  for (const Vec3& point : make_soup(body.shape, scene.folder).points) box.extend(pose.to_world(point));
  return box;
}

}  // namespace

double free_place(const Scene& scene, const Frame& frame, double room) {
  double right = -room;
  for (const Vec3& position : frame.nodes.rest_positions) right = std::max(right, position.x());
  for (std::size_t i = frame.materials.size(); i < scene.bodies.size(); ++i)
    right = std::max(right, placed_bounds(scene.bodies[i], scene).max().x());
  return right + room;
}

BodyDescription new_body(CommandId command, const Scene& scene, const Frame& frame) {
  constexpr double kRoom = 0.1;
  const Kind kind = kind_of(command);
  BodyDescription body;
  body.name = ui::free_name(scene.bodies, kind.name);
  body.shape = kind.shape;
  body.rotation_degrees = kind.rotation_degrees;
  if (const std::optional<Material> material = find_material_preset(kind.material)) body.material = *material;
  const Eigen::AlignedBox3d box = placed_bounds(body, scene);
  const double ground = scene.ground ? scene.ground->height : 0;
  const double left = scene.bodies.empty() ? 0 - box.center().x() : free_place(scene, frame, kRoom) - box.min().x();
  body.position = Vec3(left, ground - box.min().y(), 0 - box.center().z());  // avoids a negative zero
  return body;
}

BodyDescription copy_of_body(const Scene& scene, int index, const Frame& frame) {
  BodyDescription body = scene.bodies[static_cast<std::size_t>(index)];
  body.name = ui::free_name(scene.bodies, body.name);
  const Eigen::AlignedBox3d box = placed_bounds(body, scene);
  body.position.x() += free_place(scene, frame, 0.2 * box.sizes().x()) - box.min().x();
  return body;
}

}  // namespace griffith::app
