#pragma once

#include "renderer/image.h"

namespace griffith::app {

/// Ids as a picture that a PNG keeps and a person can look at: neighbouring ids have colours far apart, kNoId is black.
/// Each colour is of one id alone. Throws RenderError for an id of 16,777,215 or above.
render::Image id_picture(const render::IdImage& ids);

/// The ids that id_picture() made a picture of.
render::IdImage ids_of_picture(const render::Image& picture);

}  // namespace griffith::app
