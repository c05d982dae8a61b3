#pragma once

#include "app/bake/bake.h"
#include "app/output/export_pieces.h"

namespace griffith::app {

/// Returns the triangulated surface of a piece, with its points relative to `origin` [m]; smooth if the surface has
/// normals, else flat.
BakedMesh piece_mesh(const PieceSurface& surface, const Vec3& origin);

/// Returns the mesh of a projectile: 320 triangles for a sphere, otherwise its convex faces.
BakedMesh projectile_mesh(const ProjectileView& projectile);

}  // namespace griffith::app
