#include "app/skin_picture.h"

#include <map>

#include "app/carried_points.h"
#include "app/natural_materials.h"
#include "sim/meshing/embedding.h"
#include "sim/scene/body_pose.h"

namespace griffith::app {
namespace {

/// The tets of a scene body at rest, where they stand in the world.
struct PlacedTets {
  TetSoup soup;
  std::vector<TetId> tets;  ///< per tet of the soup
};

PlacedTets tets_of(const Frame& frame, int scene_body) {
  PlacedTets placed;
  std::map<NodeId, int> points;
  for (TetId tet(0); tet < std::ssize(frame.tets); ++tet.value) {
    if (frame.bodies[frame.tet_bodies[tet]].scene_body != scene_body) continue;
    std::array<int, 4>& corners = placed.soup.tets.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const NodeId node = frame.tets[tet][i];
      const auto [found, is_new] = points.try_emplace(node, static_cast<int>(placed.soup.points.size()));
      if (is_new) placed.soup.points.push_back(frame.rest_positions[node]);
      corners[i] = found->second;
    }
    placed.tets.push_back(tet);
  }
  return placed;
}

TriangleSurface placed_surface(const Scene& scene, const BodyDescription& body) {
  const SurfaceShape& shape = std::get<SurfaceShape>(body.shape);
  TriangleSurface surface = read_surface(scene.folder / shape.path, shape.scale);
  const Pose pose = pose_of(body);
  for (Vec3& point : surface.points) point = pose.to_world(point);
  return surface;
}

Weights single(const std::array<double, 4>& weights) {
  return Weights(float(weights[0]), float(weights[1]), float(weights[2]), float(weights[3]));
}

}  // namespace

TetId skin_carrier(const Frame& frame, const SkinPart& part) {
  return frame.tet_bodies[part.tet] == frame.tet_bodies[part.triangle_tet] ? part.tet : part.triangle_tet;
}

std::vector<SkinPart> add_skin(const Frame& frame, const Scene& scene, int scene_body, int first_part, int first_piece,
                               render::EmbeddedMesh& mesh) {
  const TriangleSurface surface = placed_surface(scene, scene.bodies[scene_body]);
  const PlacedTets placed = tets_of(frame, scene_body);
  const Embedding embedding = embed(surface, placed.soup);
  const std::vector<std::array<int, 4>> orders = summation_orders(frame);
  const std::int32_t style = render::EmbeddedStyle{look_index(scene_body, Look::outside)}.packed();
  std::vector<SkinPart> parts;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const EmbeddedTriangle& triangle = embedding.triangles[t];
    mesh.outer.push_back(static_cast<std::int32_t>(mesh.polygons.size()));
    mesh.polygons.push_back({static_cast<std::int32_t>(mesh.corners.size()), 3});
    for (int i = 0; i < 3; ++i) {
      const int index = surface.triangles[t][i];
      const EmbeddedPoint& point = embedding.points[index];
      const TetId tet = placed.tets[point.tet], other = placed.tets[triangle.tet];
      const int part = static_cast<int>(parts.size());
      mesh.corners.push_back({surface.points[index].cast<float>(), ordered(single(point.weights), orders[tet]),
                              ordered(single(triangle.weights[i]), orders[other]), tet.value, first_part + part,
                              first_piece + part, style});
      parts.push_back({tet, other});
    }
  }
  return parts;
}

}  // namespace griffith::app
