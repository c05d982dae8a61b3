#include "ui/model/entry_scale.h"

#include <algorithm>

#include "sim/scene/body_pose.h"
#include "ui/model/entry_place.h"
#include "ui/model/region_outline.h"

namespace griffith::ui {
namespace {

constexpr ScaleGroups kTogether = {0, 0, 0};

const BodyDescription& body_at(const Scene& scene, int index) { return scene.bodies[static_cast<std::size_t>(index)]; }

/// Calls `action` with the regions of a body's supports, loads and probes.
template <class AnyScene, class Action>
void for_each_region(AnyScene& scene, int index, Action action) {
  auto& body = scene.bodies[static_cast<std::size_t>(index)];
  for (auto& support : body.supports) action(support.region);
  for (auto& load : body.loads) action(load.region);
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (body_of(scene, {EntryKind::probe, static_cast<int>(i)}) != index) continue;
    if (auto* region = std::get_if<Region>(&scene.probes[i].at)) action(*region);
  }
}

/// True if splinters of the body come from a file, which is scaled as a whole.
bool has_splinter_file(const BodyDescription& body) {
  return body.splinters && (std::holds_alternative<PointSplinters>(*body.splinters) ||
                            std::holds_alternative<CellSplinters>(*body.splinters));
}

std::string_view body_problem(const Scene& scene, int index) {
  const BodyDescription& body = body_at(scene, index);
  if (std::holds_alternative<MeshFileShape>(body.shape)) return {};  // keeps its elements
  if (body.residual_stress && std::holds_alternative<StrainFile>(*body.residual_stress))
    return "The body cannot be scaled: its residual strain is a list of its elements, which would change.";
  bool listed = std::ranges::any_of(scene.probes, [&](const Probe& probe) {
    return probe.body == body.name && std::holds_alternative<ProbeNode>(probe.at);
  });
  for_each_region(scene, index, [&](const Region& region) { listed = listed || !has_place(region); });
  return listed ? "The body cannot be scaled: a region or probe of it lists nodes, which would change. Remove it, and "
                  "paint it again afterward."
                : "";
}

std::string_view region_problem(const Region& region) {
  if (!has_place(region)) return "A painted region cannot be scaled; press T to paint it.";
  if (std::holds_alternative<HalfSpaceRegion>(region)) return "A half-space has no size to scale.";
  return {};
}

void scale_splinters(SplinterPattern& splinters, const Vec3& factors) {
  if (auto* radial = std::get_if<RadialSplinters>(&splinters)) radial->center = scaled(radial->center, factors);
  if (auto* bricks = std::get_if<BrickSplinters>(&splinters)) bricks->origin = scaled(bricks->origin, factors);
  if (auto* points = std::get_if<PointSplinters>(&splinters)) points->scale = scaled(points->scale, factors.x());
  if (auto* cells = std::get_if<CellSplinters>(&splinters)) cells->scale = scaled(cells->scale, factors.x());
}

void scale_body(Scene& scene, int index, const Vec3& factors) {
  BodyDescription& body = scene.bodies[static_cast<std::size_t>(index)];
  scale_lengths(body.shape, factors);
  for_each_region(scene, index, [&](Region& region) { scale_region(region, factors); });
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    auto* at = std::get_if<ProbePoint>(&scene.probes[i].at);
    if (at && body_of(scene, {EntryKind::probe, static_cast<int>(i)}) == index) at->point = scaled(at->point, factors);
  }
  if (body.splinters) scale_splinters(*body.splinters, factors);
}

void scale_projectile(ProjectileBurst& burst, const Vec3& factors) {
  if (!burst.shape) {
    burst.radius = scaled(burst.radius, factors.x());
  } else if (auto* box = std::get_if<BoxProjectile>(&*burst.shape)) {
    box->size = scaled(box->size, factors);
  } else if (auto* hull = std::get_if<PointsProjectile>(&*burst.shape)) {
    for (Vec3& point : hull->points) point = scaled(point, factors);
  } else if (auto* surface = std::get_if<SurfaceProjectile>(&*burst.shape)) {
    surface->scale = scaled(surface->scale, factors.x());
  }
}

ScaleFrame projectile_frame(const ProjectileBurst& burst) {
  const Mat3 axes = rotation_of(burst.rotation_degrees).toRotationMatrix();
  if (!burst.shape) return {axes, kTogether, Vec3::Constant(2 * burst.radius)};
  if (const auto* box = std::get_if<BoxProjectile>(&*burst.shape)) return {axes, {0, 1, 2}, box->size};
  if (std::holds_alternative<SurfaceProjectile>(*burst.shape)) return {axes, kTogether, std::nullopt};
  Eigen::AlignedBox3d box;
  for (const Vec3& point : std::get<PointsProjectile>(*burst.shape).points) box.extend(point);
  return {axes, {0, 1, 2}, box.sizes()};
}

}  // namespace

void scale_about_place(Region& region, const Vec3& factors) {
  const Vec3 place = region_place(region);
  move_region(region, -place);
  scale_region(region, factors);
  move_region(region, place);
}

std::string_view scale_problem(const Scene& scene, const SceneEntry& entry) {
  if (entry.kind == EntryKind::body) return body_problem(scene, entry.index);
  if (entry.kind == EntryKind::camera) return "A camera has no size to scale; the wheel zooms.";
  if (const Region* region = region_of(scene, entry)) return region_problem(*region);
  return entry.kind == EntryKind::probe ? "The probe is a point, which has no size to scale." : "";
}

ScaleFrame scale_frame(const Scene& scene, const SceneEntry& entry) {
  if (entry.kind == EntryKind::projectile)
    return projectile_frame(scene.projectiles[static_cast<std::size_t>(entry.index)]);
  const BodyDescription& body = body_at(scene, *body_of(scene, entry));
  const Mat3 axes = pose_of(body).rotation.toRotationMatrix();
  if (entry.kind == EntryKind::body)
    return {axes, has_splinter_file(body) ? kTogether : scale_groups(body.shape), extents_of(body.shape)};
  const Region& region = *region_of(scene, entry);
  if (const auto* sphere = std::get_if<SphereRegion>(&region))
    return {axes, kTogether, Vec3::Constant(2 * sphere->radius)};
  const auto& box = std::get<BoxRegion>(region);
  return {axes, {0, 1, 2}, box.maximum - box.minimum};
}

void scale_entry(Scene& scene, const SceneEntry& entry, const Vec3& factors) {
  if (entry.kind == EntryKind::body) return scale_body(scene, entry.index, factors);
  if (entry.kind == EntryKind::projectile)
    return scale_projectile(scene.projectiles[static_cast<std::size_t>(entry.index)], factors);
  Region region = *region_of(scene, entry);
  scale_about_place(region, factors);
  set_region(scene, entry, region);
}

}  // namespace griffith::ui
