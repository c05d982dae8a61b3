#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/contact/solid.h"
#include "sim/file_path.h"
#include "sim/meshing/surface.h"
#include "sim/scene/body_pose.h"
#include "sim/world/phases.h"

namespace griffith {
namespace {

/// The points whose hull a projectile is.
struct Outline {
  const std::filesystem::path& folder;
  const std::string& where;

  std::vector<Vec3> operator()(const BoxProjectile& box) const {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back(0.5 * box.size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    return corners;
  }

  std::vector<Vec3> operator()(const PointsProjectile& points) const { return points.points; }

  std::vector<Vec3> operator()(const SurfaceProjectile& surface) const {
    const std::filesystem::path path = file_path(folder, surface.path);
    try {
      return read_surface(path, surface.scale).points;
    } catch (const InputError& error) {
      throw InputError(where + "/shape/surface", error.where() + ": " + error.problem(), error.remedy());
    }
  }
};

/// Corners about the centre of mass, and what the solid weighs.
Projectile convex_projectile(const std::vector<Vec3>& points, const ProjectileBurst& burst, const std::string& where) {
  ConvexHull hull = convex_hull(points);
  if (!is_solid(hull))
    throw InputError(where + "/shape", "has no volume", "give it points that do not lie in one plane");
  const Solid solid = solid_of(hull);
  Projectile projectile;
  projectile.mass = burst.density ? *burst.density * solid.volume : burst.mass;
  projectile.inertia = projectile.mass / solid.volume * solid.inertia;
  for (Vec3& corner : hull.corners) {
    corner -= solid.center;
    projectile.radius = std::max(projectile.radius, corner.norm());
  }
  projectile.hull = std::make_shared<const ConvexHull>(std::move(hull));
  return projectile;
}

Projectile sphere(const ProjectileBurst& burst) {
  Projectile projectile;
  projectile.radius = burst.radius;
  const double volume = 4.0 / 3 * std::numbers::pi * std::pow(burst.radius, 3);
  projectile.mass = burst.density ? *burst.density * volume : burst.mass;
  projectile.inertia = 0.4 * projectile.mass * burst.radius * burst.radius * Mat3::Identity();
  return projectile;
}

}  // namespace

void queue_burst(WorldState& world, const ProjectileBurst& burst, const std::string& where) {
  const Projectile projectile =
      burst.shape ? convex_projectile(std::visit(Outline{world.scene.folder, where}, *burst.shape), burst, where)
                  : sphere(burst);
  for (int i = 0; i < burst.count; ++i)
    world.pending_shots.push_back({world.time + burst.start + i * burst.interval, burst, projectile});
  std::stable_sort(world.pending_shots.begin(), world.pending_shots.end(),
                   [](const PendingShot& a, const PendingShot& b) { return a.time < b.time; });
}

void launch_projectiles(WorldState& world) {
  const double rounding = 1e-6 * world.scene.simulation.time_step;
  while (!world.pending_shots.empty() && world.pending_shots.front().time <= world.time + rounding) {
    const ProjectileBurst& burst = world.pending_shots.front().burst;
    Projectile& projectile = world.projectiles.emplace_back(world.pending_shots.front().projectile);
    const RigidState state{{burst.position, rotation_of(burst.rotation_degrees)},
                           burst.speed * burst.direction.normalized(),
                           burst.angular_velocity};
    const SurfaceProperties surface{burst.friction, burst.restitution};
    projectile.object = projectile.hull
                            ? world.contact_world.add_convex(projectile.hull->corners,
                                                             {projectile.mass, projectile.inertia}, state, surface)
                            : world.contact_world.add_sphere(projectile.radius, projectile.mass, state, surface);
    world.pending_shots.erase(world.pending_shots.begin());
  }
}

}  // namespace griffith
