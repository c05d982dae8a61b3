#include "app/picture/body_shards.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

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

/// Makes sectors and rings around the first crack, about as many as there are tets.
CellPartition radial_cells(const TetMesh& mesh, const PrincipalBox& box, int scene_body,
                           const std::optional<Vec3>& first_crack) {
  const double size = 0.8 * std::sqrt(box.sizes[1] * box.sizes[2] / mesh.tet_count());
  RadialSplinters rings;
  rings.center = first_crack.value_or(box.center);
  rings.axis = box.axes.col(0);
  rings.first_ring = size / 2;
  rings.growth = 1.4;
  rings.jitter = 0.8;
  rings.seed = scene_body + 1;
  Eigen::AlignedBox3d bounds;
  for (const Vec3& position : mesh.rest_positions) bounds.extend(position);
  return make_radial_cells(rings, bounds, size);
}

}  // namespace

bool may_have_shards(const BodyDescription& body) { return !body.splinters && !body.remeshing; }

FirstCracks first_cracks(const Frame& frame, std::size_t scene_bodies) {
  FirstCracks cracks(scene_bodies);
  for (const CrackEvent& event : frame.crack_events)
    if (std::optional<Vec3>& crack = cracks[frame.bodies[event.body].scene_body]; !crack) crack = event.rest_position;
  return cracks;
}

BodyShards make_body_shards(const Frame& frame, const Scene& scene, int scene_body, PlacedTets placed,
                            const std::optional<Vec3>& first_crack, const Monitor& monitor) {
  BodyShards shards{scene_body, std::move(placed), {}, {}};
  const TetMesh mesh = build_mesh(shards.placed.soup);
  const PrincipalBox box = principal_box(shards.placed.soup);
  shards.is_radial = breaks_radially(frame.materials[scene_body], box);
  shards.cells = shards.is_radial ? radial_cells(mesh, box, scene_body, first_crack)
                                  : make_shard_cells(mesh, shard_pattern(frame, scene_body, box));
  shards.set = make_splinters(mesh, shards.cells, monitor);
  if (const BodyDescription& body = scene.bodies[scene_body]; shows_surface(body)) {
    shards.surface = placed_surface(scene, body);
    fit_walls(shards.set, shards.placed, *shards.surface);
  }
  return shards;
}

}  // namespace griffith::app
