#include "app/output/export_pieces.h"

#include <cstdio>
#include <string>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/elasticity/element.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/carried_corner.h"

namespace griffith::app {
namespace {

template <class Polygon>
void add_polygon(PieceSurface& surface, const Polygon& points, Look look) {
  std::vector<int>& polygon = surface.polygons.emplace_back();
  for (const Vec3& point : points) {
    polygon.push_back(static_cast<int>(surface.points.size()));
    surface.points.push_back(point);
  }
  surface.looks.push_back(look);
}

/// Returns the body that owns the splinter of a part.
BodyId body_of(const Frame& frame, int part) {
  return frame.elements.bodies[frame.splinters.splinters[frame.splinters.parts[part].splinter].owner];
}

/// Adds the splinters. `is_skinned`: per scene body, true if only walls of its splinters are drawn.
void add_splinters(std::span<PieceSurface> surfaces, const Frame& frame, const std::vector<bool>& is_skinned) {
  for (const SplinterFace& face : frame.splinters.faces) {
    const BodyId body = body_of(frame, face.part);
    if (face.beyond < 0 ? is_skinned[frame.bodies[body].scene_body] : body_of(frame, face.beyond) == body) continue;
    const TetId tet = carrier(frame.splinters.splinters, frame.splinters.parts, frame.splinters.attached, face.part);
    std::vector<Vec3> points;
    for (const SplinterCorner& corner : frame.splinters.corners.subspan(face.first_corner, face.corners))
      points.push_back(carried_position(corner, frame.splinters.attached[face.part], frame.elements.tets[tet],
                                        frame.nodes.positions));
    add_polygon(surfaces[body], points, look_of(face));
  }
}

void add_tet(PieceSurface& surface, const Frame& frame, TetId tet, bool cracks_only) {
  for (int face = 0; face < 4; ++face) {
    const bool at_first = frame.elements.first_surface[tet] >> face & 1;
    if (frame.elements.neighbors[tet][face].valid() || (cracks_only && at_first)) continue;
    std::array<Vec3, 3> points;
    for (int i = 0; i < 3; ++i) points[i] = frame.nodes.positions[frame.elements.tets[tet][kTetFaces[face][i]]];
    add_polygon(surface, points, at_first ? Look::outside : Look::inside);
  }
}

/// Returns the normal of a corner of the skin, transformed with the deformation of its tet since the start.
Vec3 skin_normal(const Frame& frame, const SkinCorner& corner) {
  const TetId tet = skin_carrier(frame, corner.part);
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = frame.nodes.positions[frame.elements.tets[tet][i]];
  return (cofactor(deformation_gradient(frame.elements.rest_elements[tet], corners)) * corner.normal)
      .stableNormalized();
}

void add_skin(std::span<PieceSurface> surfaces, const Frame& frame, const Skin& skin) {
  for (int i = 0; i < skin.polygons(); ++i) {
    PieceSurface& surface = surfaces[frame.elements.bodies[skin.polygon(i).front().part.owner]];
    std::vector<Vec3> points;
    for (const SkinCorner& corner : skin.polygon(i)) {
      points.push_back(skin_position(frame, corner));
      surface.normals.push_back(skin_normal(frame, corner));
      if (skin.has_uvs) surface.uvs.push_back(corner.uv);
    }
    add_polygon(surface, points, Look::outside);
  }
}

std::string obj_text(const PieceSurface& surface) {
  std::string text;
  char line[128];
  for (const Vec3& point : surface.points) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", point.x(), point.y(), point.z());
    text += line;
  }
  for (const Vec2& uv : surface.uvs) {
    std::snprintf(line, sizeof line, "vt %.9g %.9g\n", uv.x(), uv.y());
    text += line;
  }
  for (const std::vector<int>& polygon : surface.polygons) {
    text += 'f';
    for (const int point : polygon) {
      const std::string number = std::to_string(point + 1);
      text += ' ' + (surface.uvs.empty() ? number : number + '/' + number);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

void pad(PieceSurface& surface) {
  if (!surface.normals.empty()) surface.normals.resize(surface.points.size(), Vec3::Zero());
  if (!surface.uvs.empty()) surface.uvs.resize(surface.points.size(), Vec2::Zero());
}

std::vector<PieceSurface> skin_surfaces(const Frame& frame, std::span<const Skin> skins) {
  std::vector<PieceSurface> surfaces(frame.bodies.size());
  for (const Skin& skin : skins) add_skin(surfaces, frame, skin);
  return surfaces;
}

std::vector<PieceSurface> piece_surfaces(const Frame& frame, std::span<const Skin> skins) {
  std::vector<PieceSurface> surfaces = skin_surfaces(frame, skins);
  std::vector<bool> is_skinned(frame.materials.size()), has_splinters(frame.materials.size());
  for (const Skin& skin : skins) is_skinned[skin.scene_body] = true;
  for (const Splinter& splinter : frame.splinters.splinters) has_splinters[splinter.scene_body] = true;
  add_splinters(surfaces, frame, is_skinned);
  for (const TetId tet : IdRange<TetId>(0, std::ssize(frame.elements.tets))) {
    const BodyId body = frame.elements.bodies[tet];
    const int scene_body = frame.bodies[body].scene_body;
    if (!has_splinters[scene_body]) add_tet(surfaces[body], frame, tet, is_skinned[scene_body]);
  }
  for (PieceSurface& surface : surfaces) pad(surface);
  return surfaces;
}

void export_pieces(const std::filesystem::path& folder, const Frame& frame, const Shards& shards) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(), "cannot be created as a folder", "name a writable folder");
  const FrameWithShards sharded(frame, shards);
  const std::vector<PieceSurface> surfaces = piece_surfaces(sharded.frame(), shards.skins());
  for (const BodyView& body : frame.bodies) {
    const PieceSurface& surface = surfaces[body.id];
    if (surface.polygons.empty()) continue;  // tets too small to own a splinter
    char name[32];
    std::snprintf(name, sizeof name, "body_%04d.obj", body.id.index());
    replace_file(folder / name, obj_text(surface));
  }
}

}  // namespace griffith::app
