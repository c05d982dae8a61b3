#include "app/render/gallery.h"

#include <algorithm>

#include "app/output/output.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/view_names.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// Returns the command that draws the picture of a frame.
std::string command_of(const RenderJob& job, const RenderedPicture& picture, const fs::path& page) {
  const fs::path scene = fs::proximate(job.scene, page.parent_path() / "..");
  std::string command =
      "griffith render " + scene.generic_string() + " --frame " + std::to_string(picture.record.frame);
  if (!picture.record.view.empty()) command += " --view " + picture.record.view;
  if (!picture.record.camera.empty()) command += " --camera " + picture.record.camera;
  if (job.quality)
    command += " --quality " +
               (job.poster ? "poster" : std::string(picture_quality_names()[static_cast<std::size_t>(*job.quality)]));
  if (job.sky) command += " --environment sky";
  if (!job.legend) command += " --no-legend";
  command += " --size " + std::to_string(job.width) + "x" + std::to_string(job.height);
  return command + " -o " + job.name + ".png";
}

/// Makes text safe in a cell of a table.
std::string in_table(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '|' || c == '<' || c == '>' || static_cast<unsigned char>(c) < ' '; }, ' ');
  return text;
}

std::string cell(const GalleryEntry& entry) {
  return "![" + in_table(entry.title) + "](" + entry.picture.generic_string() + ")<br>**" + in_table(entry.title) +
         ".** " + in_table(entry.text) + "<br>`" + entry.command + "`";
}

}  // namespace

std::vector<GalleryEntry> draw_gallery(const std::vector<RenderJob>& jobs, const fs::path& folder,
                                       const fs::path& page) {
  constexpr int kJpegQuality = 90;
  fs::create_directories(folder);
  std::vector<GalleryEntry> entries;
  for (const RenderJob& job : jobs) {
    const Scene scene = read_scene(job.scene);
    render_job(job, scene, false, [&](const RenderedPicture& picture) {
      const fs::path file = folder / (picture.name + ".jpg");
      replace_file(file, render::encode_jpeg(picture.image, kJpegQuality));
      entries.push_back(
          {fs::proximate(file, page.parent_path()), scene.name, scene.description, command_of(job, picture, page)});
      print("%s\n", file.c_str());
    });
  }
  return entries;
}

std::string gallery_page(const std::vector<GalleryEntry>& entries) {
  std::string text =
      "# Gallery\n\nDrawn by `griffith gallery`. Click on a picture to enlarge it.\n\n| | |\n|---|---|\n";
  for (std::size_t i = 0; i < entries.size(); i += 2)
    text += "| " + cell(entries[i]) + " | " + (i + 1 < entries.size() ? cell(entries[i + 1]) : "") + " |\n";
  return text;
}

}  // namespace griffith::app
