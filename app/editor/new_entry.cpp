#include "app/editor/new_entry.h"

#include <algorithm>

#include "app/editor/placed_surface.h"
#include "sim/scene/body_pose.h"
#include "sim/world/setup/shape_mesh.h"
#include "ui/model/scene_entry.h"

namespace griffith::app {

double free_place(const Scene& scene, const Frame& frame, double room) {
  double right = -room;
  for (const Vec3& position : frame.nodes.rest_positions) right = std::max(right, position.x());
  for (std::size_t i = frame.materials.size(); i < scene.bodies.size(); ++i)
    right = std::max(right, placed_box(scene.bodies[i], scene.folder).max().x());
  return right + room;
}

BodyDescription new_body(const TypicalBody& typical, const Scene& scene, const Frame& frame) {
  constexpr double kRoom = 0.1;
  BodyDescription body;
  body.name = ui::free_name(scene.bodies, typical.name);
  body.shape = typical.shape;
  body.rotation_degrees = typical.rotation_degrees;
  if (const std::optional<Material> material = find_material_preset(typical.material)) body.material = *material;
  const Eigen::AlignedBox3d box = placed_box(body, scene.folder);
  const double ground = scene.ground ? scene.ground->height : 0;
  const double left = scene.bodies.empty() ? 0 - box.center().x() : free_place(scene, frame, kRoom) - box.min().x();
  body.position = Vec3(left, ground - box.min().y(), 0 - box.center().z());  // avoids a negative zero
  return body;
}

BodyDescription copy_of_body(const Scene& scene, int index, const Frame& frame) {
  BodyDescription body = scene.bodies[static_cast<std::size_t>(index)];
  body.name = ui::free_name(scene.bodies, body.name);
  const Eigen::AlignedBox3d box = placed_box(body, scene.folder);
  body.position.x() += free_place(scene, frame, 0.2 * box.sizes().x()) - box.min().x();
  return body;
}

Eigen::AlignedBox3d rest_box(const Scene& scene, int body, const Frame& frame, const Scene& built) {
  const auto index = static_cast<std::size_t>(body);
  Eigen::AlignedBox3d box;
  if (index >= built.bodies.size()) {
    for (const Vec3& point : make_soup(scene.bodies[index].shape, scene.folder).points) box.extend(point);
    return box;
  }
  const Pose pose = pose_of(built.bodies[index]);
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    if (frame.bodies[frame.elements.bodies[tet]].scene_body != body) continue;
    for (const NodeId node : frame.elements.tets[tet]) box.extend(pose.to_local(frame.nodes.rest_positions[node]));
  }
  return box;
}

BoxRegion end_of_box(const Eigen::AlignedBox3d& box, const Vec3& direction) {
  constexpr double kThickness = 0.02;
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  BoxRegion end{box.min(), box.max()};
  const double depth = kThickness * box.sizes()[axis];
  if (direction[axis] > 0) end.minimum[axis] = box.max()[axis] - depth;
  if (direction[axis] <= 0) end.maximum[axis] = box.min()[axis] + depth;
  return end;
}

Support new_support(const BodyDescription& body, const Eigen::AlignedBox3d& box) {
  return {end_of_box(box, pose_of(body).rotation.conjugate() * Vec3(-Vec3::UnitY()))};
}

Load new_load(const BodyDescription& body, const Eigen::AlignedBox3d& box) {
  constexpr double kPressure = 1e4;
  Load load;
  load.region = end_of_box(box, pose_of(body).rotation.conjugate() * Vec3::UnitY());
  load.kind = LoadKind::pressure;
  load.pressure = kPressure;
  return load;
}

Probe new_probe(const Scene& scene, const BodyDescription& body, const Eigen::AlignedBox3d& box) {
  Probe probe;
  probe.name = ui::free_name(scene.probes, probe.name);
  probe.body = body.name;
  probe.at = ProbePoint{box.center()};
  return probe;
}

}  // namespace griffith::app
