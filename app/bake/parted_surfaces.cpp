#include "app/bake/parted_surfaces.h"

#include <algorithm>
#include <unordered_map>

#include "app/bake/barycentric.h"
#include "sim/splinters/carried_corner.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith::app {
namespace {

Corners corners_at(const Frame& frame, TetId tet, std::span<const Vec3> positions) {
  Corners corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = positions[frame.elements.tets[tet][i]];
  return corners;
}

/// Assignment of the parts of splinters to pieces: to the owner, or to the piece of the part's own tet if that owns no
/// splinter.
class PartedSplinters {
 public:
  PartedSplinters(const Frame& frame, const std::vector<bool>& owns_none) : frame_(frame), owns_none_(owns_none) {
    const auto& parts = frame.splinters.parts;
    for (int part = 0; part < std::ssize(parts); ++part)
      part_in_tet_[key(parts[part].splinter, parts[part].tet)] = part;
  }

  BodyId piece(int part) const {
    const BodyId own = frame_.elements.bodies[frame_.splinters.parts[part].tet];
    return owns_none_[own] ? own : frame_.elements.bodies[owner(part)];
  }

  /// Returns the splinter's part in that tet; -1: none.
  int part_in(SplinterId splinter, TetId tet) const {
    const auto found = part_in_tet_.find(key(splinter, tet));
    return found == part_in_tet_.end() ? -1 : found->second;
  }

  void add_face(PieceSurface& surface, const SplinterFace& face) const {
    add(surface, face.part, rest_points(face), look_of(face));
  }

  /// Adds the part's share of a face of its tet, where two pieces share a splinter.
  void add_cut(PieceSurface& surface, int part, int tet_face) const {
    const SplinterPart& of = frame_.splinters.parts[part];
    std::vector<Vec3> polygon;
    for (const int corner : kTetFaces[tet_face])
      polygon.push_back(frame_.nodes.rest_positions[frame_.elements.tets[of.tet][corner]]);
    for (const SplinterFace& wall : frame_.splinters.faces.subspan(of.first_face, of.faces))
      if (wall.tet_face < 0) polygon = clipped(polygon, behind(rest_points(wall)));
    if (polygon.size() >= 3) add(surface, part, polygon, Look::inside);
  }

 private:
  static std::uint64_t key(SplinterId splinter, TetId tet) {
    return std::uint64_t(splinter.index()) << 32 | std::uint32_t(tet.index());
  }

  TetId owner(int part) const { return frame_.splinters.splinters[frame_.splinters.parts[part].splinter].owner; }

  /// Returns the corners of a face in the rest position of the body.
  std::vector<Vec3> rest_points(const SplinterFace& face) const {
    const TetId tet = frame_.splinters.parts[face.part].tet;
    std::vector<Vec3> points;
    for (const SplinterCorner& corner : frame_.splinters.corners.subspan(face.first_corner, face.corners))
      points.push_back(carried_position(corner, true, frame_.elements.tets[tet], frame_.nodes.rest_positions));
    return points;
  }

  static HalfSpace behind(const std::vector<Vec3>& wall) {
    const Vec3 normal = area_vector(wall).stableNormalized();
    return {normal, normal.dot(wall.front())};
  }

  /// Adds a polygon given at rest, moved with the tet that carries the part.
  void add(PieceSurface& surface, int part, const std::vector<Vec3>& polygon, Look look) const {
    const TetId own = frame_.splinters.parts[part].tet;
    const bool by_own = owns_none_[frame_.elements.bodies[own]] || frame_.splinters.attached[part];
    const TetId tet = by_own ? own : owner(part);
    const Corners rest = corners_at(frame_, tet, frame_.nodes.rest_positions);
    const Corners now = corners_at(frame_, tet, frame_.nodes.positions);
    std::vector<int>& added = surface.polygons.emplace_back();
    for (const Vec3& point : polygon) {
      added.push_back(static_cast<int>(surface.points.size()));
      surface.points.push_back(now * barycentric(rest, point));
    }
    surface.looks.push_back(look);
  }

  const Frame& frame_;
  const std::vector<bool>& owns_none_;  ///< per body
  std::unordered_map<std::uint64_t, int> part_in_tet_;
};

/// Adds the faces of all splinters of the affected scene bodies, cut where two pieces share them.
void add_parted_splinters(std::span<PieceSurface> surfaces, const Frame& frame, const PartedSplinters& splinters,
                          const std::vector<bool>& is_parted, const std::vector<bool>& is_skinned,
                          std::span<const std::array<TetId, 4>> first_neighbors) {
  const auto& parts = frame.splinters.parts;
  for (int part = 0; part < std::ssize(parts); ++part) {
    const int scene_body = frame.splinters.splinters[parts[part].splinter].scene_body;
    if (!is_parted[scene_body]) continue;
    const BodyId piece = splinters.piece(part);
    for (const SplinterFace& face : frame.splinters.faces.subspan(parts[part].first_face, parts[part].faces))
      if (face.beyond < 0 ? !is_skinned[scene_body] : splinters.piece(face.beyond) != piece)
        splinters.add_face(surfaces[piece], face);
    for (int face = 0; face < 4; ++face) {
      const TetId beyond = first_neighbors[parts[part].tet][face];
      const int other = beyond.valid() ? splinters.part_in(parts[part].splinter, beyond) : -1;
      if (other >= 0 && splinters.piece(other) != piece) splinters.add_cut(surfaces[piece], part, face);
    }
  }
}

/// Moves polygons of a skin that mostly lie over pieces without a splinter to these pieces.
Skin handed_out(Skin skin, const Frame& frame, const std::vector<bool>& owns_none) {
  const auto at_rest = [&](TetId tet) { return corners_at(frame, tet, frame.nodes.rest_positions); };
  for (int i = 0; i < skin.polygons(); ++i) {
    const std::span<SkinCorner> polygon(skin.corners.data() + skin.first_corner[i],
                                        skin.corners.data() + skin.first_corner[i + 1]);
    const auto lies_over_none = [&](const SkinCorner& corner) {
      return bool(owns_none[frame.elements.bodies[corner.part.tet]]);
    };
    if (2 * std::ranges::count_if(polygon, lies_over_none) <= std::ssize(polygon)) continue;
    const TetId owner = std::ranges::find_if(polygon, lies_over_none)->part.tet;
    for (SkinCorner& corner : polygon) {
      const Vec3 place = at_rest(corner.part.tet) * Eigen::Map<const Eigen::Vector4d>(corner.weights.data());
      corner.part.owner = owner;
      Eigen::Map<Eigen::Vector4d>(corner.owner_weights.data()) = barycentric(at_rest(owner), place);
    }
  }
  return skin;
}

/// True for each piece without a splinter: its surface is empty.
std::vector<bool> pieces_without_splinter(const Frame& frame, std::span<const PieceSurface> surfaces) {
  std::vector<bool> owns_none(frame.bodies.size());
  for (const BodyView& body : frame.bodies) owns_none[body.id] = body.tets > 0 && surfaces[body.id].polygons.empty();
  return owns_none;
}

}  // namespace

std::vector<PieceSurface> parted_surfaces(const Frame& frame, std::span<const Skin> skins,
                                          std::span<const std::array<TetId, 4>> first_neighbors) {
  std::vector<PieceSurface> surfaces = piece_surfaces(frame, skins);
  const std::vector<bool> owns_none = pieces_without_splinter(frame, surfaces);
  std::vector<bool> is_parted(frame.materials.size()), is_skinned(frame.materials.size());
  for (const BodyView& body : frame.bodies)
    if (owns_none[body.id]) is_parted[body.scene_body] = true;
  if (std::ranges::find(is_parted, true) == is_parted.end()) return surfaces;
  std::vector<Skin> parted_skins;
  for (const Skin& skin : skins) {
    is_skinned[skin.scene_body] = true;
    if (is_parted[skin.scene_body]) parted_skins.push_back(handed_out(skin, frame, owns_none));
  }
  std::vector<PieceSurface> parted = skin_surfaces(frame, parted_skins);
  add_parted_splinters(parted, frame, PartedSplinters(frame, owns_none), is_parted, is_skinned, first_neighbors);
  for (const BodyView& body : frame.bodies) {
    if (!is_parted[body.scene_body]) continue;
    surfaces[body.id] = std::move(parted[body.id]);
    pad(surfaces[body.id]);
  }
  return surfaces;
}

}  // namespace griffith::app
