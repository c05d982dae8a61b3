#pragma once

#include "app/bake/bake.h"
#include "app/output/export_pieces.h"

namespace griffith::app {

/// A piece's surface as triangles: point by point the surface's, taken relative to `origin` [m]; smooth where it has
/// normals, else flat.
BakedMesh piece_mesh(const PieceSurface& surface, const Vec3& origin);

/// A projectile's: 320 triangles for a sphere, otherwise its convex faces.
BakedMesh projectile_mesh(const ProjectileView& projectile);

}  // namespace griffith::app
