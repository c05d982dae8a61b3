#include "app/picture/body_shards.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/picture/fit_walls.h"
#include "app/picture/natural_materials.h"
#include "app/picture/placed_surface.h"
#include "sim/mesh/topology.h"

namespace griffith::app {
namespace {

/// Bounding box of a body along its principal axes.
struct PrincipalBox {
  Mat3 axes;           ///< columns, unit length, the thinnest first
  Vec3 sizes, center;  ///< [m]
};

PrincipalBox principal_box(const TetSoup& soup) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : soup.points) mean += point / static_cast<double>(soup.points.size());
  Mat3 spread = Mat3::Zero();
  for (const Vec3& point : soup.points) spread += (point - mean) * (point - mean).transpose();
  const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();
  Eigen::AlignedBox3d box;
  for (const Vec3& point : soup.points) box.extend(Vec3(axes.transpose() * point));
  return {axes, box.sizes(), axes * box.center()};
}

bool breaks_radially(const Material& material, const PrincipalBox& box) {
  const std::string_view preset = preset_alike(material);
  return (preset == "soda_lime_glass" || preset == "acrylic") && box.sizes[0] < 0.2 * box.sizes[1];
}

/// Returns the grain of the scene's weakness, else the longest axis of the body.
Vec3 grain_of(const PrincipalBox& box, const std::optional<Weakness>& weakness) {
  if (weakness && weakness->kind == WeaknessKind::grain) return weakness->direction;
  return box.axes.col(2);
}

ShardPattern shard_pattern(const Frame& frame, int scene_body, const PrincipalBox& box) {
  constexpr double kWoodElongation = 4;
  ShardPattern pattern;
  pattern.seed = scene_body + 1;
  if (!preset_alike(frame.materials[scene_body]).starts_with("wood")) return pattern;
  pattern.grain = grain_of(box, frame.weaknesses[scene_body]);
  pattern.elongation = kWoodElongation;
  return pattern;
}

/// Returns sectors and rings around the first crack, about as many as there are tets.
RadialSplinters rings_around(const std::optional<Vec3>& first_crack, const TetSoup& soup, const PrincipalBox& box,
                             int scene_body) {
  RadialSplinters rings;
  rings.center = first_crack.value_or(box.center);
  rings.axis = box.axes.col(0);
  rings.first_ring = 0.4 * std::sqrt(box.sizes[1] * box.sizes[2] / static_cast<double>(soup.tets.size()));
  rings.growth = 1.4;
  rings.jitter = 0.8;
  rings.seed = scene_body + 1;
  return rings;
}

ShardOrder shard_order(const Frame& frame, const Scene& scene, int scene_body, const TetSoup& soup,
                       const std::optional<Vec3>& first_crack) {
  const PrincipalBox box = principal_box(soup);
  ShardOrder order{soup, shard_pattern(frame, scene_body, box), std::nullopt};
  if (breaks_radially(frame.materials[scene_body], box))
    order.pattern = rings_around(first_crack, soup, box, scene_body);
  if (const BodyDescription& body = scene.bodies[scene_body]; shows_surface(body))
    order.surface = placed_surface(scene, body);
  return order;
}

CellPartition shard_cells(const TetMesh& mesh, const ShardOrder& order) {
  if (!order.is_radial()) return make_shard_cells(mesh, std::get<ShardPattern>(order.pattern));
  Eigen::AlignedBox3d bounds;
  for (const Vec3& position : mesh.rest_positions) bounds.extend(position);
  const auto& rings = std::get<RadialSplinters>(order.pattern);
  return make_radial_cells(rings, bounds, 2 * rings.first_ring);
}

BodyShards make_body_shards(ShardOrder order, const Monitor& monitor) {
  const TetMesh mesh = build_mesh(order.soup);
  BodyShards shards{std::move(order), {}, {}};
  shards.cells = shard_cells(mesh, shards.order);
  shards.set = make_splinters(mesh, shards.cells, monitor);
  if (shards.order.surface) fit_walls(shards.set, shards.order.soup, *shards.order.surface);
  return shards;
}

}  // namespace

bool may_have_shards(const BodyDescription& body) { return !body.splinters && !body.remeshing; }

FirstCracks first_cracks(const Frame& frame, std::size_t scene_bodies) {
  FirstCracks cracks(scene_bodies);
  for (const CrackEvent& event : frame.crack_events)
    if (std::optional<Vec3>& crack = cracks[frame.bodies[event.body].scene_body]; !crack) crack = event.rest_position;
  return cracks;
}

std::shared_ptr<const BodyShards> body_shards(const Frame& frame, const Scene& scene, int scene_body,
                                              const TetSoup& soup, const std::optional<Vec3>& first_crack,
                                              const KnownShards& known, const Monitor& monitor) {
  ShardOrder order = shard_order(frame, scene, scene_body, soup, first_crack);
  const auto same = std::ranges::find_if(known, [&](const auto& shards) { return shards->order == order; });
  if (same != known.end()) return *same;
  return std::make_shared<const BodyShards>(make_body_shards(std::move(order), monitor));
}

}  // namespace griffith::app
