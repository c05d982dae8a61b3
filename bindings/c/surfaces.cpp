#include "bindings/c/surfaces.h"

#include <algorithm>
#include <array>
#include <span>

#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/carried_corner.h"

namespace griffith::c {
namespace {

/// Returns the body that owns the splinter of a part.
BodyId owner_of(const Frame& frame, int part) {
  return frame.elements.bodies[frame.splinters.splinters[frame.splinters.parts[part].splinter].owner];
}

/// Calls add(body, polygon in the world, is_crack) for the visible faces of splinters.
template <class Add>
void visit_splinters(const Frame& frame, const Add& add) {
  const Frame::Splinters& all = frame.splinters;
  std::vector<Vec3> polygon;
  for (const SplinterFace& face : all.faces) {
    const BodyId body = owner_of(frame, face.part);
    if (face.beyond >= 0 && owner_of(frame, face.beyond) == body) continue;
    const TetId tet = carrier(all.splinters, all.parts, all.attached, face.part);
    polygon.clear();
    for (const SplinterCorner& corner : all.corners.subspan(face.first_corner, face.corners))
      polygon.push_back(
          carried_position(corner, all.attached[face.part], frame.elements.tets[tet], frame.nodes.positions));
    add(body, polygon, face.beyond >= 0);
  }
}

/// Calls add(body, triangle in the world, is_crack) for the boundary faces of tetrahedra in bodies without splinters.
template <class Add>
void visit_tets(const Frame& frame, const Add& add) {
  std::vector<bool> has_splinters(frame.materials.size());
  for (const Splinter& splinter : frame.splinters.splinters) has_splinters[splinter.scene_body] = true;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(frame.elements.tets))) {
    const BodyId body = frame.elements.bodies[tet];
    if (has_splinters[frame.bodies[body].scene_body]) continue;
    for (int face = 0; face < 4; ++face) {
      if (frame.elements.neighbors[tet][face].valid()) continue;
      std::array<Vec3, 3> triangle;
      for (int i = 0; i < 3; ++i) triangle[i] = frame.nodes.positions[frame.elements.tets[tet][kTetFaces[face][i]]];
      add(body, triangle, !(frame.elements.first_surface[tet] >> face & 1));
    }
  }
}

void append(std::vector<float>& values, const Vec3& vector) {
  for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>(vector[i]));
}

}  // namespace

std::vector<Surfaces::Piece> Surfaces::pieces_of(const Frame& frame) {
  std::vector<Piece> pieces(frame.bodies.size());
  const auto add = [&](BodyId id, std::span<const Vec3> polygon, bool is_crack) {
    const BodyView& body = frame.bodies[id];
    const Pose pose{body.center_of_mass, body.orientation};
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      for (const Vec3& corner : {polygon[0], polygon[i - 1], polygon[i]})
        pieces[id].corners.push_back(pose.to_local(corner));
      pieces[id].is_crack.push_back(is_crack);
    }
  };
  visit_splinters(frame, add);
  visit_tets(frame, add);
  return pieces;
}

bool Surfaces::is_same(const Piece& known, const Piece& now) {
  constexpr double kNegligible = 1e-5;
  if (known.corners.size() != now.corners.size() || known.is_crack != now.is_crack) return false;
  double size = 0, moved = 0;
  for (std::size_t i = 0; i < now.corners.size(); ++i) {
    size = std::max(size, now.corners[i].norm());
    moved = std::max(moved, (now.corners[i] - known.corners[i]).norm());
  }
  return moved <= kNegligible * size;
}

void Surfaces::update(const Frame& frame) {
  std::vector<Piece> now = pieces_of(frame);
  bool changed = now.size() != pieces_.size();
  pieces_.resize(now.size());
  for (std::size_t body = 0; body < now.size(); ++body) {
    if (is_same(pieces_[body], now[body])) continue;
    now[body].version = pieces_[body].version + 1;
    pieces_[body] = std::move(now[body]);
    changed = true;
  }
  if (changed) flatten();
}

void Surfaces::flatten() {
  const std::vector<Piece> pieces = std::move(pieces_);
  *this = {};
  for (const Piece& piece : pieces) {
    first_vertices.push_back(static_cast<std::int32_t>(positions.size() / 3));
    first_triangles.push_back(static_cast<std::int32_t>(is_crack.size()));
    vertex_counts.push_back(static_cast<std::int32_t>(piece.corners.size()));
    triangle_counts.push_back(static_cast<std::int32_t>(piece.is_crack.size()));
    versions.push_back(piece.version);
    for (std::size_t i = 0; i < piece.corners.size(); i += 3) {
      const Vec3 &a = piece.corners[i], &b = piece.corners[i + 1], &c = piece.corners[i + 2];
      const Vec3 normal = (b - a).cross(c - a).stableNormalized();
      for (const Vec3& corner : {a, b, c}) append(positions, corner), append(normals, normal);
      for (int k = 0; k < 3; ++k) triangles.push_back(static_cast<std::int32_t>(i) + k);
    }
    is_crack.insert(is_crack.end(), piece.is_crack.begin(), piece.is_crack.end());
  }
  pieces_ = pieces;
}

}  // namespace griffith::c
