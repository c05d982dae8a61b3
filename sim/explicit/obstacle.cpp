#include "sim/explicit/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/core/rotation.h"

namespace griffith::explicit_dynamics {

ConvexSolid convex_solid(const ConvexHull& hull, double spacing) {
  ConvexSolid solid;
  solid.samples = hull.corners;
  std::map<std::pair<int, int>, std::vector<Vec3>> normals;  // by edge
  for (const std::vector<int>& face : hull.faces) {
    if (face.size() < 3) continue;
    const Vec3 &a = hull.corners[face[0]], &b = hull.corners[face[1]], &c = hull.corners[face[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    solid.faces.push_back({normal, normal.dot(a)});
    for (std::size_t i = 0; i < face.size(); ++i)
      normals[std::minmax(face[i], face[(i + 1) % face.size()])].push_back(normal);
  }
  if (solid.faces.empty())  // points in a line: nothing is behind them
    solid.faces.push_back({Vec3::UnitY(), -std::numeric_limits<double>::infinity()});
  for (const auto& [ends, of_faces] : normals) {
    const auto& [first, second] = ends;
    if (of_faces.size() == 2 && are_sharp(of_faces[0], of_faces[1]))
      solid.edges.push_back({{hull.corners[first], hull.corners[second]}, {of_faces[0], of_faces[1]}});
    const Vec3 along = hull.corners[second] - hull.corners[first];
    const int parts = std::clamp(static_cast<int>(std::ceil(along.norm() / spacing)), 1, 16);
    for (int i = 1; i < parts; ++i) solid.samples.push_back(hull.corners[first] + along * i / parts);
  }
  return solid;
}

void Obstacle::push(const Vec3& place, const Vec3& impulse) {
  if (!may_move()) return;
  was_pushed = true;
  const Vec3 before = velocity_at(place);
  state.velocity += inverse_mass * impulse;
  state.angular_velocity += inverse_inertia_now_ * (place - state.pose.translation).cross(impulse);
  energy_gained += 0.5 * impulse.dot(before + velocity_at(place));
}

void Obstacle::shift(const Vec3& place, const Vec3& impulse, double time) {
  if (!is_movable()) return;
  was_pushed = true;
  const Vec3 turn = time * (inverse_inertia_now_ * (place - state.pose.translation).cross(impulse));
  state.pose.translation += time * inverse_mass * impulse;
  if (!is_sphere()) state.pose.rotation = (Quat(rotation_by(turn)) * state.pose.rotation).normalized();
}

double Obstacle::mobility(const Vec3& place, const Vec3& direction) const {
  if (!is_movable()) return 0;
  const Vec3 lever = (place - state.pose.translation).cross(direction);
  return inverse_mass + lever.dot(inverse_inertia_now_ * lever);
}

void Obstacle::move(double dt) {
  dt += waited_;
  waited_ = 0;
  state.pose.translation += dt * state.velocity;
  if (!state.angular_velocity.isZero(0))
    state.pose.rotation = (Quat(rotation_by(dt * state.angular_velocity)) * state.pose.rotation).normalized();
  const Mat3 turn = state.pose.rotation.toRotationMatrix();
  inverse_inertia_now_ = turn * inverse_inertia * turn.transpose();
}

}  // namespace griffith::explicit_dynamics
