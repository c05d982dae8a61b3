#include "app/picture/skin.h"

#include <algorithm>
#include <unordered_set>

#include "app/picture/placed_surface.h"
#include "sim/meshing/smooth_normals.h"
#include "sim/meshing/tet_locator.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith::app {
namespace {

/// A body's surface in its initial placement, with the tets below it.
struct SurfaceOnTets {
  const TriangleSurface& surface;
  const PlacedTets& placed;
  std::vector<std::array<Vec3, 3>> normals = smooth_normals(surface);  ///< per triangle and corner
  TetLocator locator{placed.soup};

  SkinCorner corner(const Vec3& place, int owner) const {
    const EmbeddedPoint point = locator.locate(place);
    SkinCorner corner;
    corner.part = {placed.tets[point.tet], placed.tets[owner]};
    corner.weights = point.weights;
    corner.owner_weights = locator.weights_in(owner, place);
    corner.rest = place;
    return corner;
  }

  /// Interpolates the attributes of triangle `t` at barycentric coordinates.
  void dress(SkinCorner& corner, std::size_t t, const Vec3& weights) const {
    for (int i = 0; i < 3; ++i) {
      corner.normal += weights[i] * normals[t][i];
      if (!surface.uvs.empty()) corner.uv += weights[i] * surface.uvs[t][i];
    }
    corner.normal.stableNormalize();
  }
};

Skin whole_skin(const SurfaceOnTets& body, int scene_body) {
  Skin skin{scene_body, !body.surface.uvs.empty(), {0}, {}};
  for (std::size_t t = 0; t < body.surface.triangles.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int point : body.surface.triangles[t]) middle += body.surface.points[point] / 3;
    const int owner = body.locator.locate(middle).tet;
    for (int i = 0; i < 3; ++i) {
      skin.corners.push_back(body.corner(body.surface.points[body.surface.triangles[t][i]], owner));
      body.dress(skin.corners.back(), t, Vec3::Unit(i));
    }
    skin.first_corner.push_back(static_cast<int>(skin.corners.size()));
  }
  return skin;
}

/// Returns the tet that owns a point of a cell: the owner of the cell's splinter there, else that of a splinter in the
/// tet.
int owner_near(const BodyShards& shards, const TetLocator& locator, int cell, const Vec3& place) {
  const EmbeddedPoint point = locator.locate(place);
  const std::vector<int>& of_cell = shards.set.parts_of_cell[cell];
  const std::vector<int>& parts = of_cell.empty() ? shards.set.parts_of_tet[point.tet] : of_cell;
  const auto depth = [&](int part) {
    return std::ranges::min(locator.weights_in(shards.set.parts[part].tet.index(), place));
  };
  const int nearest = *std::ranges::max_element(parts, {}, depth);
  return shards.set.splinters[shards.set.parts[nearest].splinter].owner.index();
}

Vec3 barycentric(const std::array<Vec3, 3>& triangle, const Vec3& place) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  Vec3 weights;
  for (int i = 0; i < 3; ++i)
    weights[i] = (triangle[(i + 1) % 3] - place).cross(triangle[(i + 2) % 3] - place).dot(normal);
  return weights / normal.squaredNorm();
}

/// Passes every part of a triangle to `add(cell, polygon)`, starting with the cell at its center.
template <class Add>
void part(const std::array<Vec3, 3>& triangle, const CellPartition& cells, int& start, const Add& add) {
  constexpr double kSmallest = 1e-9;  // fraction of its area
  const std::vector<Vec3> whole(triangle.begin(), triangle.end());
  const double area = area_vector(whole).norm();
  start = locate(cells, (triangle[0] + triangle[1] + triangle[2]) / 3, start);
  std::vector<int> waiting = {start};
  std::unordered_set<int> seen = {start};
  while (!waiting.empty()) {
    const int cell = waiting.back();
    waiting.pop_back();
    std::vector<Vec3> polygon = whole;
    for (const CellWall& wall : cells[cell].walls) polygon = clipped(polygon, wall.inside);
    if (polygon.size() < 3 || area_vector(polygon).norm() <= kSmallest * area) continue;
    add(cell, polygon);
    for (const CellWall& wall : cells[cell].walls)
      if (wall.neighbor >= 0 && seen.insert(wall.neighbor).second) waiting.push_back(wall.neighbor);
  }
}

}  // namespace

TetId skin_carrier(const Frame& frame, const SkinPart& part) {
  return frame.elements.bodies[part.tet] == frame.elements.bodies[part.owner] ? part.tet : part.owner;
}

Vec3 skin_position(const Frame& frame, const SkinCorner& corner) {
  const TetId tet = skin_carrier(frame, corner.part);
  const std::array<double, 4>& weights = tet == corner.part.tet ? corner.weights : corner.owner_weights;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 4; ++i) position += weights[i] * frame.nodes.positions[frame.elements.tets[tet][i]];
  return position;
}

Skin make_skin(const BodyShards& shards, const PlacedTets& placed, int scene_body) {
  const SurfaceOnTets body{*shards.order.surface, placed};
  Skin skin{scene_body, !body.surface.uvs.empty(), {0}, {}};
  int start = 0;
  for (std::size_t t = 0; t < body.surface.triangles.size(); ++t) {
    std::array<Vec3, 3> triangle;
    for (int i = 0; i < 3; ++i) triangle[i] = body.surface.points[body.surface.triangles[t][i]];
    part(triangle, shards.cells, start, [&](int cell, const std::vector<Vec3>& polygon) {
      Vec3 middle = Vec3::Zero();
      for (const Vec3& place : polygon) middle += place / static_cast<double>(polygon.size());
      const int owner = owner_near(shards, body.locator, cell, middle);
      for (const Vec3& place : polygon) {
        skin.corners.push_back(body.corner(place, owner));
        body.dress(skin.corners.back(), t, barycentric(triangle, place));
      }
      skin.first_corner.push_back(static_cast<int>(skin.corners.size()));
    });
  }
  return skin;
}

std::vector<Skin> make_skins(const Frame& frame, const Scene& scene) {
  std::vector<Skin> skins;
  for (int i = 0; i < std::ssize(scene.bodies); ++i) {
    if (!shows_surface(scene.bodies[i])) continue;
    const TriangleSurface surface = placed_surface(scene, scene.bodies[i]);
    const PlacedTets placed = placed_tets(frame, i);
    skins.push_back(whole_skin(SurfaceOnTets{surface, placed}, i));
  }
  return skins;
}

}  // namespace griffith::app
