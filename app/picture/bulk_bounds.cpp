#include "app/picture/bulk_bounds.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace griffith::app {
namespace {

using Box = Eigen::AlignedBox3d;

/// A piece of a body, or a projectile.
struct Object {
  Box box;
  double mass = 0;  ///< [kg]
};

std::vector<Object> pieces(const ShownMesh& shown) {
  const Frame& frame = shown.frame;
  std::vector<Object> all(frame.bodies.size());
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    Box& box = all[frame.elements.bodies[tet]].box;
    for (const NodeId node : frame.elements.tets[tet])
      if (shown.positions[node].allFinite()) box.extend(shown.positions[node]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].mass = frame.bodies[i].mass;
  std::erase_if(all, [](const Object& object) { return object.box.isEmpty(); });
  return all;
}

double total_mass(const std::vector<Object>& objects) {
  return std::accumulate(objects.begin(), objects.end(), 0.0,
                         [](double sum, const Object& object) { return sum + object.mass; });
}

/// Returns the point with half of the mass on either side along each axis.
Vec3 median_place(std::vector<Object> objects) {
  const double half = total_mass(objects) / 2;
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [axis](const Object& object) { return object.box.center()[axis]; };
    std::ranges::stable_sort(objects, {}, along);
    double sum = 0;
    const auto middle =
        std::ranges::find_if(objects, [&](const Object& object) { return (sum += object.mass) >= half; });
    place[axis] = along(middle == objects.end() ? objects.back() : *middle);
  }
  return place;
}

/// Returns the bounding box of the objects nearest to the median that have the fraction of the mass together. `objects`
/// must not be empty.
Box core(std::vector<Object> objects) {
  constexpr double kFraction = 0.95;
  const Vec3 middle = median_place(objects);
  std::ranges::stable_sort(objects, {},
                           [&](const Object& object) { return object.box.squaredExteriorDistance(middle); });
  const double target_mass = kFraction * total_mass(objects);
  Box box;
  double sum = 0;
  for (auto object = objects.begin(); object != objects.end() && (box.isEmpty() || sum < target_mass); ++object) {
    box.extend(object->box);
    sum += object->mass;
  }
  return box;
}

}  // namespace

Eigen::AlignedBox3f bulk_bounds(const ShownMesh& shown) {
  std::vector<Object> objects = pieces(shown);
  if (objects.empty()) return {};
  Box box = core(objects);
  const Vec3 reach = Vec3::Constant(box.diagonal().norm() / 2);
  const Box near(box.min() - reach, box.max() + reach);
  for (const ProjectileView& projectile : shown.frame.projectiles) {
    const Vec3 radius = Vec3::Constant(projectile.radius);
    if (projectile.position.allFinite())
      objects.push_back({{projectile.position - radius, projectile.position + radius}});
  }
  for (const Object& object : objects)
    if (near.intersects(object.box)) box.extend(object.box);
  return box.cast<float>();
}

std::vector<Eigen::AlignedBox3f> body_bounds(const ShownMesh& shown, std::size_t count) {
  const Frame& frame = shown.frame;
  std::vector<Eigen::AlignedBox3f> boxes(count);
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    Eigen::AlignedBox3f& box = boxes[static_cast<std::size_t>(frame.bodies[frame.elements.bodies[tet]].scene_body)];
    for (const NodeId node : frame.elements.tets[tet])
      if (shown.positions[node].allFinite()) box.extend(shown.positions[node].cast<float>());
  }
  return boxes;
}

}  // namespace griffith::app
