#pragma once

#include <filesystem>
#include <vector>

#include "sim/world/frame.h"

namespace griffith::app {

/// A closed polygonal surface.
struct PieceSurface {
  std::vector<Vec3> points;                ///< world frame [m]; no two polygons share any
  std::vector<std::vector<int>> polygons;  ///< indices into `points`, counter-clockwise seen from outside
};

/// The surface of a body as it is seen: the splinters that it owns, without the walls between them, or its tets' faces
/// where the scene body has no splinters.
PieceSurface piece_surface(const Frame& frame, BodyId body);

/// Writes each body of a frame as Wavefront OBJ into a folder, made if need be: body_0000.obj, ... Throws InputError
/// when a file cannot be written.
void export_pieces(const std::filesystem::path& folder, const Frame& frame);

}  // namespace griffith::app
