#pragma once

#include <vector>

#include "renderer/embedded_surface.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What carries a corner of a body's original surface: the tet that holds it while that belongs to the body of the tet
/// that holds the triangle, else the triangle's.
struct SkinPart {
  TetId tet, triangle_tet;
};

/// The tet that carries a part in this frame.
TetId skin_carrier(const Frame& frame, const SkinPart& part);

/// Adds the surface of a scene body that was filled with tets to `mesh`; its parts are numbered from `first_part` on
/// and its pieces, one a part, from `first_piece`. `frame`: before anything broke. Throws InputError when the file
/// cannot be read.
std::vector<SkinPart> add_skin(const Frame& frame, const Scene& scene, int scene_body, int first_part, int first_piece,
                               render::EmbeddedMesh& mesh);

}  // namespace griffith::app
