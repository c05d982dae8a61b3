#include "app/bake/run_baker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bake/baked_materials.h"
#include "app/bake/fill_holes.h"
#include "app/bake/object_mesh.h"
#include "app/bake/object_names.h"
#include "app/bake/parted_surfaces.h"
#include "app/bake/piece_bonds.h"
#include "app/bake/piece_poses.h"

namespace griffith::app {
namespace {

MeshState mesh_of(const Frame& frame) {
  return {{frame.elements.tets.begin(), frame.elements.tets.end()},
          {frame.nodes.positions.begin(), frame.nodes.positions.end()}};
}

/// Returns the bodies sorted by scene body, then by number.
std::vector<BodyId> sorted_pieces(const Frame& last) {
  std::vector<BodyId> pieces;
  for (const BodyView& body : last.bodies)
    if (body.tets > 0) pieces.push_back(body.id);
  std::ranges::stable_sort(pieces, {}, [&](BodyId id) { return last.bodies[id].scene_body; });
  return pieces;
}

/// Returns the frame rate, as an integer if the steps are that even, so that other programs count the same frames.
double rate_of(std::span<const double> times, double time_step) {
  const double rate =
      times.size() < 2 ? 1 / time_step : static_cast<double>(times.size() - 1) / (times.back() - times.front());
  const double whole = std::round(rate);
  return whole > 0 && std::abs(rate - whole) < 1e-6 * whole ? whole : rate;
}

/// Returns the time of the last crack so far; minus infinity if there is none.
double last_crack_time(const Frame& frame) {
  double last = -std::numeric_limits<double>::infinity();
  for (const std::array<double, 4>& tet : frame.elements.opened)
    for (const double opened : tet)
      if (opened > last) last = opened;
  return last;
}

/// Sets the break time of each object to that of its last bond.
void set_break_times(Bake& bake) {
  for (const BakedBond& bond : bake.bonds)
    for (const int object : {bond.a, bond.b})
      bake.objects[object].break_time = std::max(bake.objects[object].break_time, bond.break_time);
}

}  // namespace

RunBaker::RunBaker(const Frame& start, const Scene& scene)
    : scene_(scene),
      shards_(start, scene),
      strength_factors_(strength_factors_at_start(start, scene)),
      first_neighbors_(start.elements.neighbors.begin(), start.elements.neighbors.end()),
      meshes_{mesh_of(start)} {}

void RunBaker::follow(const Frame& frame) {
  if (times_.empty()) opened_before_ = last_crack_time(frame);
  meshes_.push_back(mesh_of(frame));
  times_.push_back(frame.time);
  std::vector<Pose>& poses = projectiles_.emplace_back();
  for (const ProjectileView& projectile : frame.projectiles)
    poses.push_back({projectile.position, projectile.rotation});
}

Bake RunBaker::finish(const Frame& last, bool deformed) {
  shards_.follow(last, scene_);
  find_holes(last);
  const MeshHistory history(std::move(meshes_), last.nodes.rest_positions);
  const std::vector<BodyId> pieces = sorted_pieces(last);
  std::vector<int> object_of_body(last.bodies.size(), -1);
  for (int i = 0; i < std::ssize(pieces); ++i) object_of_body[pieces[i]] = i;
  const std::vector<std::string> stems = name_stems(scene_);
  Bake bake;
  bake.scene_name = scene_.name;
  for (const BodyDescription& body : scene_.bodies) bake.body_names.push_back(body.name);
  bake.frames_per_second = rate_of(times_, scene_.simulation.time_step);
  bake.times = times_;
  const BakedMaterials materials = baked_materials(scene_, stems);
  bake.materials = materials.all;
  add_pieces(bake, last, history, pieces, stems);
  for (BakedObject& object : bake.objects) object.materials = materials.of_body[object.scene_body];
  if (deformed) add_deformed_points(bake, last, history, pieces);
  add_projectiles(bake, last, stems.back(), materials.projectile);
  bake.bonds = piece_bonds({last, history, strength_factors_, object_of_body, opened_before_});
  set_break_times(bake);
  return bake;
}

/// Returns the surfaces of the last frame's bodies with its nodes at other positions, without filled holes.
std::vector<PieceSurface> RunBaker::open_surfaces_at(const Frame& last, std::span<const Vec3> positions) const {
  const FrameWithShards sharded(last, shards_);
  Frame moved = sharded.frame();
  moved.nodes.positions = positions;
  return parted_surfaces(moved, shards_.skins(), first_neighbors_);
}

/// Finds the triangles that close them, at rest, where all parts of a piece fit together.
void RunBaker::find_holes(const Frame& last) {
  for (const PieceSurface& surface : open_surfaces_at(last, last.nodes.rest_positions))
    holes_.push_back(hole_triangles(surface));
}

std::vector<PieceSurface> RunBaker::surfaces_at(const Frame& last, std::span<const Vec3> positions) const {
  std::vector<PieceSurface> surfaces = open_surfaces_at(last, positions);
  for (std::size_t i = 0; i < surfaces.size(); ++i) fill_holes(surfaces[i], holes_[i]);
  return surfaces;
}

void RunBaker::add_pieces(Bake& bake, const Frame& last, const MeshHistory& history, std::span<const BodyId> pieces,
                          std::span<const std::string> stems) const {
  const std::vector<PieceSurface> surfaces = surfaces_at(last, history.positions(1));
  std::vector<std::vector<Pose>> poses = piece_poses(last, history, 1);
  std::vector<int> numbers(scene_.bodies.size());
  for (const BodyId id : pieces) {
    const BodyView& body = last.bodies[id];
    BakedObject& object = bake.objects.emplace_back();
    object.name = numbered_name(stems[body.scene_body], numbers[body.scene_body]++);
    object.scene_body = body.scene_body;
    object.mass = body.mass;
    object.is_supported = body.supported;
    object.broke_scaled = body.broke_scaled;
    object.poses = std::move(poses[id]);
    object.mesh = piece_mesh(surfaces[id], object.poses.front().translation);
  }
}

void RunBaker::add_deformed_points(Bake& bake, const Frame& last, const MeshHistory& history,
                                   std::span<const BodyId> pieces) const {
  for (int frame = 0; frame < std::ssize(times_); ++frame) {
    const std::vector<PieceSurface> surfaces = surfaces_at(last, history.positions(1 + frame));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Pose& pose = bake.objects[i].poses[frame];
      std::vector<Vec3>& points = bake.objects[i].deformed_points.emplace_back();
      for (const Vec3& point : surfaces[pieces[i]].points) points.push_back(pose.to_local(point));
    }
  }
}

void RunBaker::add_projectiles(Bake& bake, const Frame& last, const std::string& stem, int material) const {
  for (int i = 0; i < std::ssize(last.projectiles); ++i) {
    BakedObject& object = bake.objects.emplace_back();
    object.name = numbered_name(stem, i);
    object.mass = last.projectiles[i].mass;
    object.materials.fill(material);
    object.mesh = projectile_mesh(last.projectiles[i]);
    const auto seen = [&](const std::vector<Pose>& poses) { return std::ssize(poses) > i; };
    const auto first = std::ranges::find_if(projectiles_, seen);
    object.first_frame = static_cast<int>(first - projectiles_.begin());
    for (auto poses = first; poses != projectiles_.end(); ++poses) object.poses.push_back((*poses)[i]);
  }
}

}  // namespace griffith::app
