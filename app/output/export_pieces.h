#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/picture/natural_materials.h"
#include "app/picture/shards.h"

namespace griffith::app {

/// A polygonal surface: closed, but for cracks through a body that shows the surface it was filled from.
struct PieceSurface {
  std::vector<Vec3> points;                ///< world frame [m]; no two polygons share any
  std::vector<Vec3> normals;               ///< per point: of the skin, unit, else zero; empty: no skin
  std::vector<Vec2> uvs;                   ///< per point, zeros on cracks; empty: none
  std::vector<std::vector<int>> polygons;  ///< indices into `points`, counter-clockwise seen from outside
  std::vector<Look> looks;                 ///< per polygon; inside is what a crack laid bare
};

/// The surfaces of all bodies as they are seen: what each has of its scene body's skin, and of the splinters that it
/// owns, without the walls between them, or else of its tets' faces. Empty for a body whose tets own no splinter.
/// `frame`: with the shards, where there are any.
std::vector<PieceSurface> piece_surfaces(const Frame& frame, std::span<const Skin> skins = {});
/// That of one body.
PieceSurface piece_surface(const Frame& frame, BodyId body, std::span<const Skin> skins = {});

/// What each body has of the skins alone.
std::vector<PieceSurface> skin_surfaces(const Frame& frame, std::span<const Skin> skins);
/// Gives points without a normal, where others have one, zeros; texture coordinates alike.
void pad(PieceSurface& surface);

/// Writes each body of a frame as Wavefront OBJ into a folder, made if need be: body_0000.obj, ... `shards`: of the
/// world's first frame, having followed this one. Throws InputError when a file cannot be written.
void export_pieces(const std::filesystem::path& folder, const Frame& frame, const Shards& shards = {});

}  // namespace griffith::app
