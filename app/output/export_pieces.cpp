#include "app/output/export_pieces.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/carried_corner.h"

namespace griffith::app {
namespace {

template <class Polygon>
void add_polygon(PieceSurface& surface, const Polygon& points) {
  std::vector<int>& polygon = surface.polygons.emplace_back();
  for (const Vec3& point : points) {
    polygon.push_back(static_cast<int>(surface.points.size()));
    surface.points.push_back(point);
  }
}

/// The body that owns the splinter of a part.
BodyId body_of(const Frame& frame, int part) {
  return frame.elements.bodies[frame.splinters.splinters[frame.splinters.parts[part].splinter].owner];
}

void add_splinters(PieceSurface& surface, const Frame& frame, BodyId body, bool walls_only) {
  for (const SplinterFace& face : frame.splinters.faces) {
    if (body_of(frame, face.part) != body || (walls_only && face.beyond < 0)) continue;
    if (face.beyond >= 0 && body_of(frame, face.beyond) == body) continue;
    const TetId tet = carrier(frame.splinters.splinters, frame.splinters.parts, frame.splinters.attached, face.part);
    std::vector<Vec3> points;
    for (const SplinterCorner& corner : frame.splinters.corners.subspan(face.first_corner, face.corners))
      points.push_back(carried_position(corner, frame.splinters.attached[face.part], frame.elements.tets[tet],
                                        frame.nodes.positions));
    add_polygon(surface, points);
  }
}

void add_tets(PieceSurface& surface, const Frame& frame, BodyId body, bool cracks_only) {
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
    if (frame.elements.bodies[tet] != body) continue;
    for (int face = 0; face < 4; ++face) {
      const bool at_first = frame.elements.first_surface[tet] >> face & 1;
      if (frame.elements.neighbours[tet][face].valid() || (cracks_only && at_first)) continue;
      std::array<Vec3, 3> points;
      for (int i = 0; i < 3; ++i) points[i] = frame.nodes.positions[frame.elements.tets[tet][kTetFaces[face][i]]];
      add_polygon(surface, points);
    }
  }
}

void add_skin(PieceSurface& surface, const Frame& frame, BodyId body, const Skin& skin) {
  for (int i = 0; i < skin.polygons(); ++i) {
    if (frame.elements.bodies[skin.polygon(i).front().part.owner] != body) continue;
    std::vector<Vec3> points;
    for (const SkinCorner& corner : skin.polygon(i)) {
      points.push_back(skin_position(frame, corner));
      if (skin.has_uvs) surface.uvs.push_back(corner.uv);
    }
    add_polygon(surface, points);
  }
}

bool has_splinters(const Frame& frame, int scene_body) {
  for (const Splinter& splinter : frame.splinters.splinters)
    if (splinter.scene_body == scene_body) return true;
  return false;
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

PieceSurface piece_surface(const Frame& frame, BodyId body, std::span<const Skin> skins) {
  PieceSurface surface;
  const int scene_body = frame.bodies[body].scene_body;
  const auto skin = std::ranges::find(skins, scene_body, &Skin::scene_body);
  const bool is_skinned = skin != skins.end();
  if (is_skinned) add_skin(surface, frame, body, *skin);
  if (has_splinters(frame, scene_body)) {
    add_splinters(surface, frame, body, is_skinned);
  } else {
    add_tets(surface, frame, body, is_skinned);
  }
  if (!surface.uvs.empty()) surface.uvs.resize(surface.points.size(), Vec2::Zero());
  return surface;
}

void export_pieces(const std::filesystem::path& folder, const Frame& frame, const Shards& shards) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(), "is no folder and cannot be made one", "name a folder that may be written to");
  const FrameWithShards sharded(frame, shards);
  for (const BodyView& body : frame.bodies) {
    const PieceSurface surface = piece_surface(sharded.frame(), body.id, shards.skins());
    if (surface.polygons.empty()) continue;  // tets too small to own a splinter
    char name[32];
    std::snprintf(name, sizeof name, "body_%04d.obj", body.id.value);
    replace_file(folder / name, obj_text(surface));
  }
}

}  // namespace griffith::app
