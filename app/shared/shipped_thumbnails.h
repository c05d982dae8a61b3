#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// Size of thumbnails [pixels].
inline constexpr int kThumbnailWidth = 480, kThumbnailHeight = 270;

/// Returns the file of a scene's shipped thumbnail: in a folder next to it, named by the scene's file and a hash of its
/// content, as "thumbnails/arch.0123456789abcdef.jpg". A scene edited since has none. Throws InputError if the scene
/// cannot be read.
std::filesystem::path shipped_thumbnail_file(const std::filesystem::path& scene);

/// Returns that thumbnail; empty if there is none, or the file holds no picture of that size.
std::optional<render::Image> shipped_thumbnail(const std::filesystem::path& scene);

/// Stores the thumbnail for shipped_thumbnail() and removes those of earlier versions of the scene. Throws InputError
/// if it cannot be written.
void ship_thumbnail(const std::filesystem::path& scene, const render::Image& picture);

/// Returns the thumbnails next to the scenes of a folder that belong to none of them: to scenes that were edited or
/// removed. Throws InputError if a scene cannot be read.
std::vector<std::filesystem::path> stale_thumbnails(const std::filesystem::path& folder);

}  // namespace griffith::app
