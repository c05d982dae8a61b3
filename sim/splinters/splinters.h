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

/// Piece of a body's material that follows its tets but hides their facets (Parker & O'Brien 2009, section 5). It moves
/// with its owner.
struct Splinter {
  TetId owner;         ///< tet with the largest part of it
  int scene_body = 0;  ///< index into Scene::bodies
  int first_part = 0, parts = 0;
  double volume = 0;  ///< volume at rest [m³]
};

/// Intersection of a splinter and a tet.
struct SplinterPart {
  SplinterId splinter;
  TetId tet;
  double volume = 0;  ///< volume at rest [m³]
  int first_face = 0, faces = 0;
};

/// Connection of two parts of one splinter through a face between their tets.
struct PartLink {
  int a = 0, b = 0;  ///< parts
  int face = 0;      ///< face 0..3 of a's tet
};

/// Convex polygon of a splinter's surface: a piece of the body's surface, or of a wall toward another splinter.
struct SplinterFace {
  int part = 0;
  int beyond = -1;            ///< wall: the part of the other splinter behind it; -1: the body's surface
  std::int8_t tet_face = -1;  ///< 0..3: this face of the part's tet contains it; -1: inside the tet
  SplinterMatter matter = SplinterMatter::body;
  int first_corner = 0, corners = 0;  ///< counterclockwise seen from outside
};

using Weights = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;  ///< barycentric coordinates in a tet

/// Corner of a face with its barycentric weights in tets. They sum to 1.
struct SplinterCorner {
  Eigen::Vector3f rest;   ///< in the body's rest space [m]
  Weights weights;        ///< weights in its part's tet, not negative but for rounding
  Weights owner_weights;  ///< weights in the owner, of any sign
};

/// Splinters of bodies and their surfaces. They do not change when bodies break.
struct SplinterSet {
  std::vector<Splinter> splinters;
  std::vector<SplinterPart> parts;  ///< parts by splinter, then tet
  std::vector<PartLink> links;      ///< by splinter
  std::vector<int> first_link;      ///< per splinter, and the end
  std::vector<SplinterFace> faces;  ///< by part
  std::vector<SplinterCorner> corners;
  std::vector<std::vector<int>> parts_of_tet;   ///< parts per tet of the mesh
  std::vector<std::vector<int>> parts_of_cell;  ///< parts per cell that they were made from; not set by append()
};

/// Returns the splinters that cells make of a body. `mesh` is in rest space. Disconnected pieces of a splinter become
/// separate splinters. A splinter of less than a tenth of the volume of the neighbor with the largest common wall joins
/// it. Throws Cancelled when the monitor cancels.
SplinterSet make_splinters(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor = {});

/// Part of a body without splinters.
struct Uncovered {
  double volume = 0;          ///< [m³]
  Vec3 place = Vec3::Zero();  ///< center of the tet with the largest uncovered volume [m]
};

/// Returns the uncovered part. Cells that do not fill the box around the body may leave some.
Uncovered uncovered_part(const TetMesh& mesh, const SplinterSet& splinters);

/// Appends the splinters of a body whose tets begin at `first_tet` of the mesh of all.
void append(SplinterSet& all, const SplinterSet& of_body, TetId first_tet, int scene_body);

/// Point of a splinter and the part that it follows.
struct HullCorner {
  int part = 0, corner = 0;
};

/// Returns points on each splinter whose convex hull contains it, without duplicates.
std::vector<std::vector<HullCorner>> hull_corners(const SplinterSet& splinters);

/// State of splinters: the tets that they follow, and their visible faces.
struct SplinterState {
  std::vector<std::uint8_t> attached;  ///< per part: 1 while its tet is connected with the owner through the splinter
  std::vector<std::uint8_t> open;      ///< per face: 1 on the surface and for walls opened by a crack
  std::vector<int> open_walls;         ///< the opened walls, in the order of opening
};

/// Returns the state with everything attached and all walls closed.
SplinterState intact_state(const SplinterSet& splinters);

/// Follows the cracks that separated `changed_tets` from some neighbor. `neighbors`: those of all tets, present state.
/// A part without its owner moves by the owner's affine map. A wall opens when its two sides follow separated tets,
/// permanently. The cost is that of the splinters in these tets.
void follow_cracks(const SplinterSet& splinters, std::span<const std::array<TetId, 4>> neighbors,
                   std::span<const TetId> changed_tets, SplinterState& state);

}  // namespace griffith
