#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// Point that follows a tet: the weighted sum of its corners. The weights sum to 1; some are negative outside the tet.
struct EmbeddedPoint {
  int tet = -1;
  std::array<double, 4> weights = {};
};

/// Triangle that follows the tet at its center as a whole.
struct EmbeddedTriangle {
  int tet = -1;
  std::array<std::array<double, 4>, 3> weights = {};
};

/// Detailed surface that follows the deformation of coarser tets: as one skin where they are connected, and triangle by
/// triangle where they have separated.
struct Embedding {
  std::vector<EmbeddedPoint> points;  ///< per point of the surface: in the tet that contains it, else in the nearest
  std::vector<EmbeddedTriangle> triangles;  ///< per triangle of the surface
};

/// Embeds a surface in tets. `soup`: prepared, not empty, in the same space as the surface.
Embedding embed(const TriangleSurface& surface, const TetSoup& soup);

/// Deformed tets of a whole world that an embedding follows. Those of the embedding begin at `first_tet`.
struct CarryingTets {
  std::span<const std::array<NodeId, 4>> tets;
  std::span<const BodyId> bodies;   ///< per tet
  std::span<const Vec3> positions;  ///< per node
  TetId first_tet;
};

/// Returns the present corners of a triangle of the surface. Points follow their own tets if these belong to the body
/// of the triangle's tet, else that tet, so that no triangle spans two bodies.
std::array<Vec3, 3> embedded_corners(const Embedding& embedding, const TriangleSurface& surface, int triangle,
                                     const CarryingTets& carrying);

/// Returns unit normals per triangle and corner: those of the file if it has any. Otherwise the mean, weighted by
/// angle, over the triangles at the point that meet this one at less than `crease` [radians]. Zero if there is none.
std::vector<std::array<Vec3, 3>> smooth_normals(const TriangleSurface& surface, double crease = 0.7);

}  // namespace griffith
