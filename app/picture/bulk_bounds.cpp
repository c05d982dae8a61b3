#include "app/picture/bulk_bounds.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace griffith::app {
namespace {

using Box = Eigen::AlignedBox3d;

/// A piece of a body, or a projectile.
struct Thing {
  Box box;
  double mass = 0;  ///< [kg]
};

std::vector<Thing> pieces(const ShownMesh& shown) {
  const Frame& frame = shown.frame;
  std::vector<Thing> all(frame.bodies.size());
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    Box& box = all[frame.elements.bodies[tet]].box;
    for (const NodeId node : frame.elements.tets[tet])
      if (shown.positions[node].allFinite()) box.extend(shown.positions[node]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].mass = frame.bodies[i].mass;
  std::erase_if(all, [](const Thing& thing) { return thing.box.isEmpty(); });
  return all;
}

double total_mass(const std::vector<Thing>& things) {
  return std::accumulate(things.begin(), things.end(), 0.0,
                         [](double sum, const Thing& thing) { return sum + thing.mass; });
}

/// Returns the point with half of the mass on either side along each axis.
Vec3 median_place(std::vector<Thing> things) {
  const double half = total_mass(things) / 2;
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [axis](const Thing& thing) { return thing.box.center()[axis]; };
    std::ranges::stable_sort(things, {}, along);
    double sum = 0;
    const auto middle = std::ranges::find_if(things, [&](const Thing& thing) { return (sum += thing.mass) >= half; });
    place[axis] = along(middle == things.end() ? things.back() : *middle);
  }
  return place;
}

/// Returns the bounding box of the objects nearest to the median that have the fraction of the mass together. `objects`
/// must not be empty.
Box core(std::vector<Thing> things) {
  constexpr double kFraction = 0.95;
  const Vec3 middle = median_place(things);
  std::ranges::stable_sort(things, {}, [&](const Thing& thing) { return thing.box.squaredExteriorDistance(middle); });
  const double wanted = kFraction * total_mass(things);
  Box box;
  double sum = 0;
  for (auto thing = things.begin(); thing != things.end() && (box.isEmpty() || sum < wanted); ++thing) {
    box.extend(thing->box);
    sum += thing->mass;
  }
  return box;
}

}  // namespace

Eigen::AlignedBox3f bulk_bounds(const ShownMesh& shown) {
  std::vector<Thing> things = pieces(shown);
  if (things.empty()) return {};
  Box box = core(things);
  const Vec3 reach = Vec3::Constant(box.diagonal().norm() / 2);
  const Box near(box.min() - reach, box.max() + reach);
  for (const ProjectileView& projectile : shown.frame.projectiles) {
    const Vec3 radius = Vec3::Constant(projectile.radius);
    if (projectile.position.allFinite())
      things.push_back({{projectile.position - radius, projectile.position + radius}});
  }
  for (const Thing& thing : things)
    if (near.intersects(thing.box)) box.extend(thing.box);
  return box.cast<float>();
}

}  // namespace griffith::app
