#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/picture/natural_materials.h"
#include "app/picture/shards.h"

namespace griffith::app {

/// A polygonal surface: closed, except for cracks through a body that shows its original surface.
struct PieceSurface {
  std::vector<Vec3> points;                ///< world frame [m]; not shared between polygons
  std::vector<Vec3> normals;               ///< per point: unit normal of the skin, else zero; empty: no skin
  std::vector<Vec2> uvs;                   ///< texture coordinates per point, zero on cracks; empty: none
  std::vector<std::vector<int>> polygons;  ///< indices into `points`, counterclockwise seen from outside
  std::vector<Look> looks;                 ///< per polygon; inside for faces opened by cracks
};

/// Returns the visible surfaces of all bodies: their parts of the scene body's skin and of their own splinters without
/// the walls between them, or else the faces of their tets. Empty for a body whose tets own no splinter. `frame`:
/// including the shards, if there are any.
std::vector<PieceSurface> piece_surfaces(const Frame& frame, std::span<const Skin> skins = {});

/// Returns only each body's parts of the skins.
std::vector<PieceSurface> skin_surfaces(const Frame& frame, std::span<const Skin> skins);
/// Pads missing normals and texture coordinates with zeros.
void pad(PieceSurface& surface);

/// Writes each body of a frame as Wavefront OBJ into a folder, made if necessary: body_0000.obj, ... `shards`: of the
/// world's first frame, having followed this one. Throws InputError if a file cannot be written.
void export_pieces(const std::filesystem::path& folder, const Frame& frame, const Shards& shards = {});

}  // namespace griffith::app
