#include "ui/model/entry_place.h"

#include <type_traits>

#include "sim/scene/body_pose.h"
#include "ui/model/region_outline.h"

namespace griffith::ui {
namespace {

/// Returns the pose of the body to which the entry belongs; empty if it has none.
std::optional<Pose> pose_of_body(const Scene& scene, const SceneEntry& entry) {
  const std::optional<int> body = body_of(scene, entry);
  return body ? std::optional(pose_of(scene.bodies[static_cast<std::size_t>(*body)])) : std::nullopt;
}

/// Returns the entry's point in the rest space of its body; nullptr for other kinds.
Vec3* probed_point(Scene& scene, const SceneEntry& entry) {
  if (entry.kind != EntryKind::probe) return nullptr;
  auto* point = std::get_if<ProbePoint>(&scene.probes[static_cast<std::size_t>(entry.index)].at);
  return point ? &point->point : nullptr;
}

template <class AnyScene>
auto* region_in(AnyScene& scene, const SceneEntry& entry) {
  using AnyRegion = std::conditional_t<std::is_const_v<AnyScene>, const Region, Region>;
  return visit_entry(scene, entry, [](auto& item) -> AnyRegion* {
    if constexpr (requires { item.region; }) {
      return &item.region;
    } else if constexpr (requires { item.at; }) {
      return std::get_if<Region>(&item.at);
    } else {
      return nullptr;
    }
  });
}

std::optional<Vec3> rest_place(const Scene& scene, const SceneEntry& entry) {
  if (const Region* region = region_of(scene, entry))
    return has_place(*region) ? std::optional(region_place(*region)) : std::nullopt;
  if (entry.kind != EntryKind::probe) return std::nullopt;
  const auto* point = std::get_if<ProbePoint>(&scene.probes[static_cast<std::size_t>(entry.index)].at);
  return point ? std::optional(point->point) : std::nullopt;
}

}  // namespace

std::optional<Placement> placement_of(const Scene& scene, const SceneEntry& entry) {
  const auto index = static_cast<std::size_t>(entry.index);
  switch (entry.kind) {
    case EntryKind::body:
      return Placement{scene.bodies[index].position, scene.bodies[index].rotation_degrees};
    case EntryKind::projectile:
      return Placement{scene.projectiles[index].position};
    case EntryKind::camera:
      return Placement{scene.cameras[index].target};
    default: {
      const std::optional<Pose> pose = pose_of_body(scene, entry);
      const std::optional<Vec3> place = rest_place(scene, entry);
      return pose && place ? std::optional(Placement{pose->to_world(*place)}) : std::nullopt;
    }
  }
}

bool can_turn(const SceneEntry& entry) { return entry.kind == EntryKind::body || entry.kind == EntryKind::projectile; }

void move_entry(Scene& scene, const SceneEntry& entry, const Placement& from, const Placement& to) {
  const auto index = static_cast<std::size_t>(entry.index);
  const Vec3 offset = to.position - from.position;
  if (entry.kind == EntryKind::body) {
    scene.bodies[index].position = to.position;
    scene.bodies[index].rotation_degrees = to.rotation_degrees;
  } else if (entry.kind == EntryKind::projectile) {
    ProjectileBurst& burst = scene.projectiles[index];
    burst.position = to.position;
    if (to.rotation_degrees != from.rotation_degrees)
      burst.direction =
          rotation_of(to.rotation_degrees) * (rotation_of(from.rotation_degrees).conjugate() * burst.direction);
  } else if (entry.kind == EntryKind::camera) {
    scene.cameras[index].target = moved_place(scene.cameras[index].target, offset);
    scene.cameras[index].position = moved_place(scene.cameras[index].position, offset);
  } else if (const std::optional<Pose> pose = pose_of_body(scene, entry)) {
    const Vec3 in_rest = pose->rotation.conjugate() * offset;
    if (Region* region = region_in(scene, entry)) move_region(*region, in_rest);
    if (Vec3* point = probed_point(scene, entry)) *point = moved_place(*point, in_rest);
  }
}

const Region* region_of(const Scene& scene, const SceneEntry& entry) { return region_in(scene, entry); }

void set_region(Scene& scene, const SceneEntry& entry, const Region& region) {
  if (Region* own = region_in(scene, entry)) *own = region;
}

}  // namespace griffith::ui
