#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/render/render_job.h"

namespace griffith::app {

/// A picture of a gallery with what is said about it.
struct GalleryEntry {
  std::filesystem::path picture;  ///< relative to the page
  std::string title, text;        ///< name and description of the scene
  std::string command;            ///< draws the picture again
};

/// Draws the pictures of the jobs as JPEG files into a folder, and returns an entry for each, with paths relative to
/// `page`. Needs a current OpenGL context. Throws InputError as render_job() does.
std::vector<GalleryEntry> draw_gallery(const std::vector<RenderJob>& jobs, const std::filesystem::path& folder,
                                       const std::filesystem::path& page);

/// Returns the page in Markdown: pictures in two columns, each with title, text and command.
std::string gallery_page(const std::vector<GalleryEntry>& entries);

}  // namespace griffith::app
