#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/convex_cells.h"

namespace griffith {

using SplinterId = Id<struct SplinterTag>;

/// A piece of a body's material that tets carry but that never deforms their facets into view (Parker & O'Brien 2009,
/// section 5). It goes where its owner goes.
struct Splinter {
  TetId owner;         ///< the tet with the largest share of it
  int scene_body = 0;  ///< index into Scene::bodies
  int first_part = 0, parts = 0;
  double volume = 0;  ///< at rest [m³]
};

/// What a splinter and a tet have in common.
struct SplinterPart {
  SplinterId splinter;
  TetId tet;
  double volume = 0;  ///< at rest [m³]
  int first_face = 0, faces = 0;
};

/// Two parts of one splinter hold together through a face between their tets.
struct PartLink {
  int a = 0, b = 0;  ///< parts
  int face = 0;      ///< 0..3 of a's tet
};

/// A convex polygon of a splinter's surface: a piece of the body's surface, or of a wall towards another splinter.
struct SplinterFace {
  int part = 0;
  int beyond = -1;            ///< a wall: the part of the other splinter behind it; -1: the body's surface
  std::int8_t tet_face = -1;  ///< 0..3: lies in this face of the part's tet; -1: inside the tet
  SplinterMatter matter = SplinterMatter::body;
  int first_corner = 0, corners = 0;  ///< counter-clockwise seen from outside
};

using Weights = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;  ///< barycentric, of a tet's corners

/// A corner of a face and how tets carry it: barycentric weights, which add up to 1.
struct SplinterCorner {
  Eigen::Vector3f rest;   ///< in the body's rest space [m]
  Weights weights;        ///< in its part's tet, none below 0 but for rounding
  Weights owner_weights;  ///< in the owner, of any sign
};

/// The splinters of bodies and their surfaces; nothing of it changes when bodies break.
struct SplinterSet {
  std::vector<Splinter> splinters;
  std::vector<SplinterPart> parts;  ///< by splinter, then tet
  std::vector<PartLink> links;      ///< by splinter
  std::vector<int> first_link;      ///< per splinter, and the end
  std::vector<SplinterFace> faces;  ///< by part
  std::vector<SplinterCorner> corners;
  std::vector<std::vector<int>> parts_of_tet;   ///< per tet of the mesh
  std::vector<std::vector<int>> parts_of_cell;  ///< per cell that they were made from; append() leaves it out
};

/// The splinters that cells make of a body. `mesh` is in rest space. Pieces of a splinter that hang together through no
/// common face become splinters of their own, and what has less than a tenth of the volume of the neighbour with which
/// it shares the largest wall joins it. Throws Cancelled when the monitor says so.
SplinterSet make_splinters(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor = {});

/// What of a body no splinter holds.
struct Uncovered {
  double volume = 0;          ///< [m³]
  Vec3 place = Vec3::Zero();  ///< the middle of the tet that misses most [m]
};

/// Cells that do not fill the box round the body may leave something out.
Uncovered uncovered_part(const TetMesh& mesh, const SplinterSet& splinters);

/// Adds the splinters of a body whose tets begin at `first_tet` of the mesh of all.
void append(SplinterSet& all, const SplinterSet& of_body, TetId first_tet, int scene_body);

/// A place on a splinter and the part that carries it.
struct HullCorner {
  int part = 0, corner = 0;
};

/// Places on each splinter of which it is the convex hull, none twice.
std::vector<std::vector<HullCorner>> hull_corners(const SplinterSet& splinters);

/// How splinters are carried and what is seen of them.
struct SplinterState {
  std::vector<std::uint8_t> attached;  ///< per part: 1 while its tet holds together with the owner through the splinter
  std::vector<std::uint8_t> open;      ///< per face: 1 on the surface and for walls that a crack has opened
  std::vector<int> open_walls;         ///< the walls among them, in the order in which they opened
};

/// Everything attached, all walls closed.
SplinterState intact_state(const SplinterSet& splinters);

/// Follows the cracks that parted `changed_tets` from some neighbour. `neighbours`: of all tets, as they are now. A
/// part that has lost its owner is carried by the owner's affine map; a wall opens when what carries its two sides
/// parts. Walls never close again. Costs the splinters in these tets.
void follow_cracks(const SplinterSet& splinters, std::span<const std::array<TetId, 4>> neighbours,
                   std::span<const TetId> changed_tets, SplinterState& state);

}  // namespace griffith
