#pragma once

#include "renderer/image.h"

namespace griffith::app {

/// Returns a picture of ids that a PNG can hold and a person can read: neighboring ids have very different colors,
/// kNoId is black. Each color belongs to one id. Throws RenderError for an id of 16,777,215 or above.
render::Image id_picture(const render::IdImage& ids);

/// Returns the ids from a picture made by id_picture().
render::IdImage ids_of_picture(const render::Image& picture);

}  // namespace griffith::app
