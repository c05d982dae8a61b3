#include "ui/model/snap.h"

#include <algorithm>
#include <cmath>

#include "sim/geometry/triangle.h"
#include "ui/model/region_outline.h"
#include "ui/model/surface_hit.h"

namespace griffith::ui {
namespace {

constexpr char kGround[] = "the ground";

/// Returns the surfaces of all bodies in the placement of the scene, without the deformation by the loads at the start.
std::vector<PlacedSurface> placed_surfaces(const Scene& scene, const Frame& frame) {
  std::vector<PlacedSurface> surfaces(scene.bodies.size());
  std::vector<int> index(frame.nodes.rest_positions.size(), -1);
  for_each_surface_face(frame, [&](std::size_t tet, const std::array<NodeId, 3>& corners) {
    const int body = frame.bodies[frame.elements.bodies[TetId(tet)]].scene_body;
    PlacedSurface& surface = surfaces[static_cast<std::size_t>(body)];
    std::array<int, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      int& point = index[corners[i]];
      if (point < 0) {
        point = static_cast<int>(surface.points.size());
        surface.points.push_back(frame.nodes.rest_positions[corners[i]]);
        surface.box.extend(surface.points.back());
      }
      triangle[i] = point;
    }
    std::ranges::sort(triangle);
    surface.triangles.push_back(triangle);
  });
  return surfaces;
}

void append(PlacedSurface& all, const PlacedSurface& added) {
  const int first = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), added.points.begin(), added.points.end());
  for (const auto& [a, b, c] : added.triangles) all.triangles.push_back({a + first, b + first, c + first});
  all.box.extend(added.box);
}

/// First surface that a ray hits.
struct RayHit {
  double distance = 0;
  Vec3 normal = Vec3::UnitY();  ///< on the side of the eye
  std::string_view name;
};

/// Returns the hit if it is nearer than the one found before.
void take_nearer(std::optional<RayHit>& found, const ViewRay& ray, double distance, Vec3 normal,
                 std::string_view name) {
  if (distance <= 0 || (found && found->distance <= distance)) return;
  if (normal.dot(ray.direction) > 0) normal = -normal;
  found = RayHit{distance, normal, name};
}

std::optional<RayHit> first_hit(const SnapScene& scene, const ViewRay& ray) {
  std::optional<RayHit> found;
  if (scene.ground && ray.direction.y() < 0)
    take_nearer(found, ray, (*scene.ground - ray.origin.y()) / ray.direction.y(), Vec3::UnitY(), kGround);
  for (const auto& [name, surface] : scene.others)
    for (const auto& [a, b, c] : surface.triangles) {
      const Vec3 &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
      if (const auto distance = triangle_hit(ray.origin, ray.direction, p, q, r))
        take_nearer(found, ray, *distance, (q - p).cross(r - p).normalized(), name);
    }
  return found;
}

/// Returns the least coordinate of a surface along a direction [m].
double lowest_along(const PlacedSurface& surface, const Vec3& direction) {
  double lowest = surface.points.front().dot(direction);
  for (const Vec3& point : surface.points) lowest = std::min(lowest, point.dot(direction));
  return lowest;
}

double height_along(const PlacedSurface& surface, const Vec3& direction) {
  return -lowest_along(surface, -direction) - lowest_along(surface, direction);
}

/// Returns how far a surface on a plane of that normal is from what is below it along the normal [m]; < 0 if it has
/// sunk into it. What it would have to leave by more than half its height is not below it.
double clearance(const SnapScene& scene, const PlacedSurface& moved, const Vec3& normal, bool on_ground) {
  const double deepest = -height_along(moved, normal) / 2;
  std::optional<double> least = on_ground ? std::optional(0.0) : std::nullopt;
  for (const SnapBody& other : scene.others) {
    const std::optional<double> gap = gap_along(normal, moved, other.surface);
    if (gap && *gap > deepest && (!least || *gap < *least)) least = gap;
  }
  return least.value_or(0);
}

/// True if the surfaces are farther apart along the direction than `reach`, on either side.
bool boxes_apart(const PlacedSurface& ahead, const PlacedSurface& behind, const Vec3& direction, double reach) {
  const Vec3 axis = direction.cwiseAbs(), centers = ahead.box.center() - behind.box.center();
  const double way = centers.dot(direction), half = (ahead.box.sizes() + behind.box.sizes()).dot(axis) / 2;
  return std::abs(way) > half + reach;
}

/// Returns the least displacement along tangents of a plane that takes a surface out of another one; empty if they do
/// not overlap, which is exact for convex ones.
std::optional<Vec3> out_of(const PlacedSurface& moved, const PlacedSurface& other, const Vec3& normal) {
  constexpr double kTouching = 1e-6;  // [m]
  const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
  std::optional<Vec3> least;
  for (const Vec3& direction : {normal, Vec3(-normal), first, Vec3(-first), second, Vec3(-second)}) {
    const std::optional<double> gap = gap_along(direction, moved, other);
    if (!gap || *gap > -kTouching) return std::nullopt;
    const bool is_tangent = std::abs(direction.dot(normal)) < 0.5;
    if (is_tangent && (!least || -*gap < least->norm())) least = -*gap * direction;
  }
  return least;
}

/// Moves a surface along a plane until it overlaps no other one, where a few displacements suffice.
void make_room(const SnapScene& scene, PlacedSurface& moved, const Vec3& normal) {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    bool found = false;
    for (const SnapBody& other : scene.others)
      if (const std::optional<Vec3> way = out_of(moved, other.surface, normal)) {
        move_surface(moved, *way);
        found = true;
      }
    if (!found) return;
  }
}

/// Returns the displacement that raises a surface which has sunk into the ground [m].
Vec3 out_of_ground(const SnapScene& scene, const PlacedSurface& moved) {
  if (!scene.ground) return Vec3::Zero();
  return Vec3(0, std::max(0.0, *scene.ground - moved.box.min().y()), 0);
}

}  // namespace

SnapScene snap_scene(const Scene& scene, const Frame& frame, const SceneEntry& entry,
                     const std::vector<SceneEntry>& moved) {
  SnapScene result;
  const std::vector<PlacedSurface> surfaces = placed_surfaces(scene, frame);
  const bool is_body = entry.kind == EntryKind::body;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const SceneEntry body{EntryKind::body, static_cast<int>(i)};
    if (surfaces[i].points.empty()) continue;
    if (body == entry || std::ranges::find(moved, body) != moved.end()) {
      if (is_body) append(result.moved, surfaces[i]);
    } else {
      result.others.push_back({scene.bodies[i].name, surfaces[i]});
    }
  }
  if (scene.ground) result.ground = scene.ground->height;
  if (entry.kind == EntryKind::projectile) {
    const ProjectileBurst& burst = scene.projectiles[static_cast<std::size_t>(entry.index)];
    if (!burst.shape) result.radius = burst.radius;
  }
  return result;
}

std::optional<Snap> snap_to_ray(const SnapScene& scene, const Vec3& place, const ViewRay& ray) {
  const std::optional<RayHit> hit = first_hit(scene, ray);
  if (!hit) return std::nullopt;
  const Vec3 point = ray.origin + hit->distance * ray.direction, &normal = hit->normal;
  Snap snap{Vec3::Zero(), std::string(hit->name), point, normal};
  if (scene.moved.points.empty()) {
    snap.offset = point + scene.radius * normal - place;
    return snap;
  }
  PlacedSurface moved = scene.moved;
  const Vec3 center = moved.box.center();
  const Vec3 along = point - center;
  const Vec3 onto = along - along.dot(normal) * normal + (point.dot(normal) - lowest_along(moved, normal)) * normal;
  move_surface(moved, onto);
  move_surface(moved, -clearance(scene, moved, normal, hit->name == kGround) * normal);
  move_surface(moved, out_of_ground(scene, moved));
  make_room(scene, moved, normal);
  snap.offset = moved.box.center() - center;
  return snap;
}

std::optional<Snap> snap_along(const SnapScene& scene, const Vec3& offset, int axis, double reach) {
  if (scene.moved.points.empty()) return std::nullopt;
  PlacedSurface moved = scene.moved;
  move_surface(moved, offset);
  std::optional<Snap> found;
  double nearest = reach;
  const auto take = [&](double gap, const Vec3& direction, const std::string& name) {
    if (std::abs(gap) > nearest) return;
    nearest = std::abs(gap);
    const Vec3 end = moved.box.center() - moved.box.sizes()[axis] / 2 * direction - gap * direction;
    found = Snap{offset - gap * direction, name, end, direction};
  };
  if (axis == 1 && scene.ground) take(moved.box.min().y() - *scene.ground, Vec3::UnitY(), kGround);
  for (const SnapBody& other : scene.others)
    for (const double sign : {1.0, -1.0}) {
      const Vec3 direction = sign * Vec3::Unit(axis);
      if (boxes_apart(moved, other.surface, direction, reach)) continue;
      if (const auto gap = gap_along(direction, moved, other.surface)) take(*gap, direction, other.name);
    }
  return found;
}

}  // namespace griffith::ui
