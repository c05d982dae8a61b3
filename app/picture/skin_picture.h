#pragma once

#include "app/picture/skin.h"
#include "renderer/embedded_surface.h"

namespace griffith::app {

/// Adds a body's surface to `mesh`; its parts, one a corner, are numbered from `first_part` on, its pieces, one a part,
/// from `first_piece`. `frame`: before anything broke.
void add_skin(const Frame& frame, const Skin& skin, int first_part, int first_piece, render::EmbeddedMesh& mesh);

}  // namespace griffith::app
