#include "app/editor/new_entry.h"

#include "sim/scene/body_pose.h"
#include "sim/world/setup/shape_mesh.h"
#include "ui/model/scene_entry.h"

namespace griffith::app {

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
