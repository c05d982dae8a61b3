#include "sim/world/conditions/projectiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/contact/mass_properties.h"
#include "sim/core/file_path.h"
#include "sim/meshing/surface.h"
#include "sim/scene/body_pose.h"
#include "sim/scene/scene_fields.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Points whose hull is the shape of a projectile.
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

/// Returns a projectile with its corners relative to the center of mass, and the mass of the solid.
Projectile convex_projectile(const std::vector<Vec3>& points, const ProjectileBurst& burst, const std::string& where) {
  ConvexHull hull = convex_hull(points);
  if (!is_solid(hull))
    throw InputError(where + "/shape", "has no volume", "give it points that do not lie in one plane");
  const MassProperties solid = mass_properties(hull);
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

/// Throws, about the field `where`, if many projectiles start inside one another, as they would if nothing moved the
/// earlier ones: the number of contacts grows with the square of a crowd.
void require_no_crowd(const std::vector<PendingShot>& shots, const Vec3& gravity, const std::string& where) {
  constexpr int kMaxInside = 32;
  std::vector<Vec3> velocities;
  for (const PendingShot& shot : shots) velocities.push_back(shot.burst.speed * shot.burst.direction.normalized());
  for (std::size_t i = 0; i < shots.size(); ++i) {
    int inside = 0;
    for (std::size_t j = 0; j < i && inside <= kMaxInside; ++j) {
      const double t = shots[i].time - shots[j].time;
      const Vec3 flown = t * velocities[j] + t * t / 2 * gravity;
      const Vec3 apart = shots[i].burst.position - shots[j].burst.position - flown;
      inside += apart.norm() < shots[i].projectile.radius + shots[j].projectile.radius;
    }
    if (inside > kMaxInside)
      throw InputError(where, "start inside more than 32 others of them",
                       "use a longer interval, a higher speed or different positions");
  }
}

/// Queues the shots of a burst, its start counted from now. Throws InputError, about the field `where` of the scene,
/// for a surface file that cannot be read or has no volume.
void queue_burst(WorldState& world, const ProjectileBurst& burst, const std::string& where) {
  const Projectile projectile =
      burst.shape ? convex_projectile(std::visit(Outline{world.model->scene.folder, where}, *burst.shape), burst, where)
                  : sphere(burst);
  ProjectileBurst flight = burst;
  flight.shape.reset();  // the projectile has it, once for the whole burst
  std::vector<PendingShot>& pending = world.pending_shots;
  const std::ptrdiff_t before = std::ssize(pending);
  for (int i = 0; i < burst.count; ++i)
    pending.push_back({world.time + burst.start + i * burst.interval, flight, projectile});
  if (before == 0 || pending[before].time >= pending[before - 1].time) return;
  std::inplace_merge(pending.begin(), pending.begin() + before, pending.end(),
                     [](const PendingShot& a, const PendingShot& b) { return a.time < b.time; });
}

}  // namespace

void queue_bursts(WorldState& world) {
  for (std::size_t i = 0; i < world.model->scene.projectiles.size(); ++i)
    queue_burst(world, world.model->scene.projectiles[i], "#/projectiles/" + std::to_string(i));
  require_no_crowd(world.pending_shots, world.model->scene.gravity, "#/projectiles");
}

ProjectileBurst fire_burst(WorldState& world, const ProjectileBurst& burst) {
  if (burst.count < 1) throw InputError("shot", "has no projectile", "give it a count of at least 1");
  const double numbers = burst.speed + burst.start + burst.interval + burst.position.sum();
  if (!std::isfinite(numbers) || !(burst.direction.norm() > 0) || !std::isfinite(burst.direction.sum()))
    throw InputError("shot", "has a value that is not finite, or no direction", "give finite numbers and a direction");
  const std::int64_t before = std::ssize(world.projectiles) + std::ssize(world.pending_shots);
  if (before + burst.count > kMaxProjectiles)
    throw InputError("shot", "brings the scene to more than 10,000 projectiles", "start it again, or fire fewer");
  ProjectileBurst self_contained = burst;
  if (burst.shape && std::holds_alternative<SurfaceProjectile>(*burst.shape)) {
    const std::string where = "shot";
    self_contained.shape =
        PointsProjectile{convex_hull(std::visit(Outline{world.model->scene.folder, where}, *burst.shape)).corners};
  }
  std::vector<PendingShot> pending = world.pending_shots;
  try {
    queue_burst(world, self_contained, "shot");
    require_no_crowd(world.pending_shots, world.model->scene.gravity, "shot");
  } catch (const InputError&) {
    world.pending_shots = std::move(pending);
    throw;
  }
  return self_contained;
}

void launch_projectiles(WorldState& world) {
  const double rounding = 1e-6 * world.model->scene.simulation.time_step;
  std::vector<PendingShot>& pending = world.pending_shots;
  const auto due =
      std::ranges::find_if(pending, [&](const PendingShot& shot) { return shot.time > world.time + rounding; });
  for (auto shot = pending.begin(); shot != due; ++shot) {
    const ProjectileBurst& burst = shot->burst;
    Projectile& projectile = world.projectiles.emplace_back(shot->projectile);
    const RigidState state{{burst.position, rotation_of(burst.rotation_degrees)},
                           burst.speed * burst.direction.normalized(),
                           burst.angular_velocity};
    const SurfaceProperties surface = projectile.surface = {burst.friction, burst.restitution};
    projectile.object = projectile.hull
                            ? world.contact_world.add_convex(projectile.hull->corners,
                                                             {projectile.mass, projectile.inertia}, state, surface)
                            : world.contact_world.add_sphere(projectile.radius, projectile.mass, state, surface);
    account_launch(world, projectile, state);
  }
  pending.erase(pending.begin(), due);
}

}  // namespace griffith
