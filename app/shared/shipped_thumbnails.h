#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// Size of thumbnails [pixels].
inline constexpr int kThumbnailWidth = 480, kThumbnailHeight = 270;

/// The file of the thumbnail that comes with a scene: in a folder beside it, named by the scene's file and a hash of
/// what is in it, as "thumbnails/arch.0123456789abcdef.jpg". A scene that was edited since has none. Throws InputError
/// where the scene cannot be read.
std::filesystem::path shipped_thumbnail_file(const std::filesystem::path& scene);

/// That thumbnail; nothing where there is none, or no picture of that size in the file.
std::optional<render::Image> shipped_thumbnail(const std::filesystem::path& scene);

/// Puts the thumbnail where shipped_thumbnail() finds it, in place of those that the scene had before it was edited.
/// Throws InputError where that cannot be written.
void ship_thumbnail(const std::filesystem::path& scene, const render::Image& picture);

/// Files beside the scenes of a folder that are thumbnails of none of them as it is now: of edited scenes, and of those
/// that are gone. Throws InputError where a scene cannot be read.
std::vector<std::filesystem::path> stale_thumbnails(const std::filesystem::path& folder);

}  // namespace griffith::app
