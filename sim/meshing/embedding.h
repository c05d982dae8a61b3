#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/ids.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/meshing/surface.h"

namespace griffith {

/// A point carried by a tet: the weighted sum of its corners. The weights add up to 1; outside of the tet some are
/// negative.
struct EmbeddedPoint {
  int tet = -1;
  std::array<double, 4> weights = {};
};

/// A triangle carried whole by the tet of its middle.
struct EmbeddedTriangle {
  int tet = -1;
  std::array<std::array<double, 4>, 3> weights = {};
};

/// A detailed surface that follows the deformation of coarser tets: as one skin while they hold together, and triangle
/// by triangle where they have parted.
struct Embedding {
  std::vector<EmbeddedPoint> points;        ///< per point of the surface: in the tet that holds it, else the nearest
  std::vector<EmbeddedTriangle> triangles;  ///< per triangle of the surface
};

/// Embeds a surface in tets. `soup`: prepared, not empty, in the same space as the surface.
Embedding embed(const TriangleSurface& surface, const TetSoup& soup);

/// Deformed tets to carry an embedding: all of a world's, of which the embedding's begin at `first_tet`.
struct CarryingTets {
  std::span<const std::array<NodeId, 4>> tets;
  std::span<const BodyId> bodies;   ///< per tet
  std::span<const Vec3> positions;  ///< per node
  TetId first_tet;
};

/// Where the corners of a triangle of the surface are now: as the points' own tets carry them while these belong to the
/// body of the triangle's tet, else as that tet alone does, so that no triangle spans two bodies.
std::array<Vec3, 3> embedded_corners(const Embedding& embedding, const TriangleSurface& surface, int triangle,
                                     const CarryingTets& carrying);

/// Per triangle and corner the normal that the surface has from its file, else the mean of the normals, weighted by
/// angle, of the triangles at the point that meet this one at less than `crease` [radians]. Of unit length, zero where
/// there is none.
std::vector<std::array<Vec3, 3>> smooth_normals(const TriangleSurface& surface, double crease = 0.7);

}  // namespace griffith
