#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/file_formats.h"
#include "app/output/output.h"
#include "app/render/gallery.h"
#include "app/render/read_render_jobs.h"
#include "renderer/egl_context.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

struct GalleryOptions {
  std::filesystem::path jobs, page;
  std::optional<int> egl_device;
};

void make_gallery(const GalleryOptions& options) {
  require_extension(options.page, ".md", "Markdown file");
  const std::vector<RenderJob> jobs = read_render_jobs(options.jobs);
  const std::filesystem::path page = std::filesystem::absolute(options.page);
  const std::filesystem::path folder = page.parent_path() / page.stem();
  check_replaceable(page);
  check_folder(folder);
  const render::EglContext context(options.egl_device);
  replace_file(page, gallery_page(draw_gallery(jobs, folder, page)));
}

}  // namespace

Command add_gallery(CLI::App& program) {
  CLI::App* command = program.add_subcommand("gallery", "Draw a page of pictures of scenes");
  const auto options = std::make_shared<GalleryOptions>();
  command->add_option("JOBS", options->jobs, "JSON file of the pictures, as for render --job-file")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->page,
                   "Markdown file to write; its pictures are JPEG files in a folder of the same name next to it")
      ->required()
      ->type_name("FILE");
  add_egl_device(*command, options->egl_device);
  add_threads(*command);
  command->footer(
      "Example:\n  griffith gallery docs/gallery.json -o docs/gallery.md\n\n"
      "Each picture has the name and description of its scene, and the command that draws it.");
  return {command, [options] {
            make_gallery(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
