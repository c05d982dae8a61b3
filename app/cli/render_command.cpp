#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <set>

#include "app/cli/commands.h"
#include "app/output/file_formats.h"
#include "app/output/output.h"
#include "app/render/frame_list.h"
#include "app/render/picture_output.h"
#include "app/render/read_render_jobs.h"
#include "app/render/render_job.h"
#include "app/shared/scene_files.h"
#include "app/shared/text_table.h"
#include "renderer/egl_context.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/quantities.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/view_names.h"
#include "sim/world/output/quantity_values.h"

namespace griffith::app {
namespace {

struct RenderOptions {
  RenderJob job;                              ///< its scene is one of `scenes`
  std::vector<std::filesystem::path> scenes;  ///< scene files, or folders of them
  std::filesystem::path output;    ///< a PNG file, or a folder for the pictures of several scenes or of a job file
  std::filesystem::path job_file;  ///< empty: only `job`
  std::string only;                ///< name of the only job of the file to draw; empty: all
  std::vector<std::string> set;    ///< "POINTER=VALUE"
  int frame = 0, every = 0;
  std::string frames;  ///< as in frames_from_text(); empty: `frame` and `every`
  PictureOutput pictures;
  std::optional<int> egl_device;
  bool list_views = false;
};

std::string place_name(const Quantity& quantity) {
  if (!quantity.has_values()) return "";
  const ValuePlace place = place_of(quantity);
  return place == ValuePlace::node ? "node" : place == ValuePlace::tet ? "element" : "face";
}

/// Prints the names of --view: a table of the quantities, then layers and styles.
void list_views() {
  std::vector<std::vector<std::string>> lines = {{"quantity", "per", "meaning"}};
  for (const Quantity* quantity : view_quantities()) {
    const std::string unit = quantity->unit.empty() ? "" : " [" + std::string(quantity->unit) + "]";
    lines.push_back({std::string(quantity->key), place_name(*quantity), std::string(quantity->meaning) + unit});
  }
  std::string text = text_table(lines) + "\nlayers:";
  for (const ViewLayerInfo& layer : view_layers()) text.append(" ").append(layer.key);
  text += "\nstyles:";
  for (const std::string_view style : element_style_names()) text.append(" ").append(style);
  print("%s exploded slice unlit deformed=400\n", text.c_str());
}

/// Parses "1280x720". Returns an error text for CLI11, or an empty one.
std::string read_size(const std::string& text, RenderJob& job) {
  char rest = 0;
  const bool good = std::sscanf(text.c_str(), "%dx%d%c", &job.width, &job.height, &rest) == 2;
  if (good && is_possible_size(job.width, job.height)) return {};
  return "--size: \"" + text +
         "\" is not a size: write WIDTHxHEIGHT, such as 1280x720, each from 16 to 65536 and 400 million pixels at most";
}

/// True if even a single picture gets a numbered name.
bool is_numbered(const RenderOptions& options) { return options.every > 0 || !options.frames.empty(); }

/// True if several scenes are drawn, so that their names are those of the pictures.
bool is_batch(const RenderOptions& options) {
  return options.scenes.size() > 1 || (options.scenes.size() == 1 && std::filesystem::is_directory(options.scenes[0]));
}

/// Returns the scenes of the command line, with those in folders.
std::vector<std::filesystem::path> all_scenes(const RenderOptions& options) {
  std::vector<std::filesystem::path> all;
  for (const std::filesystem::path& path : options.scenes) {
    if (!std::filesystem::is_directory(path)) {
      all.push_back(path);
      continue;
    }
    const std::vector<std::filesystem::path> found = scenes_in(path);
    if (found.empty()) throw InputError(path.string(), "has no scene files", "name a folder with .json scenes");
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

/// Returns the job of a scene on the command line.
RenderJob job_of(const RenderOptions& options, const std::filesystem::path& scene) {
  RenderJob job = options.job;
  job.scene = scene;
  job.name = is_batch(options) ? scene.stem().string() : options.output.stem().string();
  if (!options.frames.empty()) {
    job.frames = frames_from_text(options.frames, "--frames");
  } else if (options.every > 0) {
    job.frames =
        frames_from_text("0:" + std::to_string(options.frame) + ":" + std::to_string(options.every), "--every");
  } else {
    job.frames = {options.frame};
  }
  return job;
}

/// Returns the jobs of the scenes on the command line. Throws InputError if two would have the same pictures.
std::vector<RenderJob> jobs_of_scenes(const RenderOptions& options) {
  std::vector<RenderJob> jobs;
  std::set<std::string> names;
  for (const std::filesystem::path& scene : all_scenes(options)) {
    jobs.push_back(job_of(options, scene));
    if (!names.insert(jobs.back().name).second)
      throw InputError(scene.string(), "has the name of an earlier scene, and so have its pictures",
                       "rename it, or draw it by itself");
  }
  return jobs;
}

std::vector<RenderJob> jobs_of(const RenderOptions& options) {
  if (options.job_file.empty()) return jobs_of_scenes(options);
  std::vector<RenderJob> jobs = read_render_jobs(options.job_file);
  if (options.only.empty()) return jobs;
  std::erase_if(jobs, [&](const RenderJob& job) { return job.name != options.only; });
  if (jobs.empty())
    throw InputError(options.job_file.string(), "has no job \"" + options.only + "\"", "use one of its names");
  return jobs;
}

/// Throws InputError for a repeated view or camera, which would write the same files twice.
void check_names(const RenderJob& job) {
  std::set<std::string> names;
  for (const std::string& camera : job.cameras)
    for (const std::string& view : job.views)
      if (!names.insert(picture_name(job, camera, view, 0, false)).second)
        throw InputError("--view and --camera", "name a picture twice", "give each once");
}

/// Throws InputError for outputs that cannot be written or arguments that contradict each other, before the work.
void check_arguments(const RenderOptions& options) {
  if (options.job_file.empty() == options.scenes.empty())
    throw InputError("render", "needs either a scene or --job-file FILE", "give one of them");
  if (options.output.empty() && options.pictures.contact_sheet.empty() && options.pictures.video.empty())
    throw InputError("render", "has no output", "add -o, --contact-sheet or --video");
  if (!options.pictures.contact_sheet.empty()) {
    require_extension(options.pictures.contact_sheet, ".png", "PNG file");
    check_replaceable(options.pictures.contact_sheet);
  }
  if (!options.pictures.video.empty()) check_video_path(options.pictures.video);
  if (options.job_file.empty()) check_names(job_of(options, options.scenes.front()));
  if (options.output.empty()) return;
  if (!options.job_file.empty() || is_batch(options)) {
    if (options.output.extension() == ".png" && !std::filesystem::is_directory(options.output))
      throw InputError(options.output.string(), "is the name of a picture, but there are several scenes",
                       "name a folder for their pictures");
    return check_folder(options.output);
  }
  require_extension(options.output, ".png", "PNG file");
  RenderJob job = job_of(options, options.scenes.front());
  check_replaceable(
      options.output.parent_path() /
      (picture_name(job, job.cameras.front(), job.views.front(), job.frames.front(), is_numbered(options)) + ".png"));
}

/// Returns the name of an output of one of several scenes: "sheet.png" becomes "sheet_wall.png".
std::filesystem::path of_scene(const std::filesystem::path& file, const std::string& scene) {
  return file.parent_path() / (file.stem().string() + "_" + scene + file.extension().string());
}

void render_pictures(const RenderOptions& options, const RenderJob& job, const std::string& renderer) {
  const Scene scene = read_scene(job.scene, settings(options.set));
  PictureOutput output = options.pictures;
  output.renderer = renderer;
  if (!options.output.empty()) {
    const bool is_folder = !options.job_file.empty() || is_batch(options);
    output.folder = is_folder ? options.output : options.output.parent_path();
    if (output.folder.empty()) output.folder = ".";
  }
  if (is_batch(options))
    for (std::filesystem::path* file : {&output.contact_sheet, &output.video})
      if (!file->empty()) *file = of_scene(*file, job.name);
  PictureWriter writer(output, job, scene.simulation.time_step);
  const std::string explanation =
      render_job(job, scene, is_numbered(options), [&](const RenderedPicture& picture) { writer.write(picture); });
  writer.finish();
  print("%s", explanation.c_str());
}

/// Draws scene after scene, also those after one that cannot be drawn. Returns the exit code.
ExitCode render_batch(const RenderOptions& options, const std::vector<RenderJob>& jobs, const std::string& renderer) {
  std::size_t failed = 0;
  for (const RenderJob& job : jobs) {
    print_error("%s\n", job.scene.c_str());
    try {
      render_pictures(options, job, renderer);
    } catch (const InputError& error) {
      print_error("%s\n", printable(error.what()).c_str());
      ++failed;
    }
  }
  if (failed > 0) print_error("%zu of %zu scenes could not be drawn\n", failed, jobs.size());
  return failed > 0 ? kBadInput : kDone;
}

ExitCode render(const RenderOptions& options) {
  check_arguments(options);
  const std::vector<RenderJob> jobs = jobs_of(options);
  const render::EglContext context(options.egl_device);
  print_error("Graphics: %s (%s)\n", context.renderer().c_str(), context.origin().c_str());
  if (is_batch(options)) return render_batch(options, jobs, context.renderer());
  for (const RenderJob& job : jobs) render_pictures(options, job, context.renderer());
  return kDone;
}

void add_what(CLI::App& command, RenderOptions& options) {
  command.add_option("SCENE", options.scenes, "Scene files, or folders of them")->type_name("FILE");
  add_settings(command, options.set);
  command.add_option("--job-file", options.job_file, "Draw the pictures of the jobs in a JSON file")->type_name("FILE");
  command.add_option("--only", options.only, "Run only the named job")->type_name("NAME");
  CLI::Option* frame = command.add_option("--frame", options.frame, "Time steps before the picture")
                           ->check(CLI::Range(0, kMaxFrames))
                           ->type_name("N");
  CLI::Option* every = command.add_option("--every", options.every, "Numbered pictures every K steps, from 0 to N")
                           ->check(CLI::Range(1, kMaxFrames))
                           ->type_name("K");
  command
      .add_option("--frames", options.frames,
                  "Several time steps in one run: FROM:TO:STRIDE, such as 0:240:10, or a list, 0,30,60")
      ->excludes(frame)
      ->excludes(every)
      ->type_name("LIST");
  command
      .add_option(
          "--view", options.job.views,
          "View: a quantity to color by, a layer, wireframe, shrunken, exploded, slice, unlit or deformed=400; several "
          "joined by +, "
          "such as utilization+fracture_planes+slice. Default: the scene's view. May be repeated for several pictures")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME");
  command
      .add_option("--camera", options.job.cameras,
                  "Camera of the scene; default: the first. May be repeated for several pictures")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME");
  command
      .add_option("--turntable", options.job.turntable,
                  "N pictures around the camera's target in place of one, at equal angles")
      ->check(CLI::Range(2, kMaxTurntable))
      ->type_name("N");
  command
      .add_option("--microsteps", options.job.microsteps,
                  "N pictures of microsteps of the last time step in place of one, at equal intervals: an impact in "
                  "slow motion, with the time in µs")
      ->check(CLI::Range(1, kMaxMicrosteps))
      ->type_name("N");
  command
      .add_option(
          "--node", options.job.node,
          "Node to explain, in text and by the views candidate_plane and element_forces; default: the most loaded one")
      ->check(CLI::Range(0, 1 << 30))
      ->type_name("N");
}

void add_how(CLI::App& command, RenderOptions& options) {
  command
      .add_option_function<std::string>(
          "--size",
          [&options](const std::string& text) {
            const std::string problem = read_size(text, options.job);
            if (!problem.empty()) throw CLI::ValidationError(problem);
          },
          "Size of the picture, drawn in parts if it is large; default: 1280x720")
      ->type_name("WxH");
  command
      .add_option(
          "--samples", options.job.samples,
          "Samples per pixel for antialiasing; default: 4, or 1 in draft quality and in each of the 48 pictures of a "
          "poster")
      ->check(CLI::Range(1, 16))
      ->type_name("S");
  command
      .add_option_function<std::string>(
          "--quality", [&options](const std::string& name) { set_quality(options.job, name); },
          "draft (the fastest), standard or high (soft shadows, transparent glass), or poster (also depth of field "
          "about "
          "the camera's target and motion blur, without text; some twenty times slower than high); default: the "
          "scene's "
          "view")
      ->check(CLI::IsMember(quality_names()).description(""))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--environment", [&options](const std::string& name) { options.job.sky = name == "sky"; },
          "Surroundings that light the picture and are mirrored: studio or sky; default: studio")
      ->check(CLI::IsMember({"studio", "sky"}).description(""))
      ->type_name("NAME");
  command.add_flag("--list-views", options.list_views, "List the names of --view and draw nothing");
  command.add_flag("--ui", options.job.interface, "Draw the editor's panels into the picture");
  command.add_flag("--legend,!--no-legend", options.job.legend, "Draw the legend of the colors; default: on");
  command.add_flag("--transparent", options.job.transparent,
                   "Draw neither sky nor ground; empty pixels are transparent");
  add_egl_device(command, options.egl_device);
}

void add_where(CLI::App& command, RenderOptions& options) {
  command
      .add_option(
          "-o,--output", options.output,
          "PNG file to write; several pictures have camera, view, frame and angle or microstep in their names. With "
          "--job-file, several "
          "scenes or a folder: a folder")
      ->type_name("FILE");
  command
      .add_option("--contact-sheet", options.pictures.contact_sheet,
                  "Write all pictures into one PNG file, small, in rows")
      ->type_name("FILE");
  command
      .add_option(
          "--video", options.pictures.video,
          "Write the pictures as " + video_extensions() + " with ffmpeg; one video for each scene, camera and view")
      ->type_name("FILE");
  command
      .add_option("--fps", options.pictures.frames_per_second,
                  "Frames per second of the video; default: real time, or 30 for a turntable or microsteps")
      ->check(CLI::Range(0.1, 240.0))
      ->type_name("N");
  command.add_flag("--records", options.pictures.records,
                   "Write the record of each PNG file: numbers and the state's hash (.json), text or widgets (.txt), "
                   "ids of the drawn objects (.ids.png)");
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Render scenes to PNG files or videos without a window");
  const auto options = std::make_shared<RenderOptions>();
  add_what(*command, *options);
  add_how(*command, *options);
  add_where(*command, *options);
  add_threads(*command);
  CLI::Option* job_file = command->get_option("--job-file");
  for (const char* name :
       {"SCENE",    "--frame",       "--every",         "--frames",  "--turntable", "--microsteps",  "--view",
        "--camera", "--node",        "--size",          "--samples", "--quality",   "--environment", "--ui",
        "--legend", "--transparent", "--contact-sheet", "--video",   "--fps",       "--set"})
    job_file->excludes(command->get_option(name));
  command->get_option("--only")->needs(job_file);
  command->footer(
      "Examples:\n"
      "  griffith render scenes/wall_small.json --frame 60 -o wall.png\n"
      "  griffith render scenes/wall_small.json --frames 0:240:4 -o wall.png    wall_0000.png, wall_0004.png, ...\n"
      "  griffith render scenes/wall_small.json --frames 0:240 --video wall.mp4\n"
      "  griffith render scenes/wall_small.json --frames 0,20,40 --view material --view utilization "
      "--contact-sheet sheet.png\n"
      "  griffith render scenes/wall_small.json --frame 30 --view utilization --size 1920x1080 -o utilization.png\n"
      "  griffith render scenes/wall_small.json --frame 40 --turntable 90 --video around.mp4\n"
      "  griffith render scenes/glass_pane.json --frame 2 --microsteps 240 --video impact.mp4\n"
      "  griffith render scenes/wall_small.json --frame 40 --size 16000x9000 -o large.png\n"
      "  griffith render scenes --frame 60 -o pictures                          wall_small.png, arch.png, ...\n"
      "  griffith render --job-file pictures.json -o pictures");
  return {command, [options] {
            if (options->list_views) {
              list_views();
              return kDone;
            }
            if (options->job.interface && options->job.poster)
              throw InputError("--quality poster", "cannot be combined with --ui", "use --quality high");
            if (options->job.interface && options->job.transparent)
              throw InputError("--transparent", "cannot be combined with --ui", "leave one of them out");
            if (options->job.interface && options->job.turntable > 0)
              throw InputError("--turntable", "cannot be combined with --ui", "leave one of them out");
            if (options->job.interface && options->job.microsteps > 0)
              throw InputError("--microsteps", "cannot be combined with --ui", "leave one of them out");
            if (options->job.turntable > 0 && options->job.microsteps > 0)
              throw InputError("--microsteps", "cannot be combined with --turntable", "leave one of them out");
            return render(*options);
          }};
}

}  // namespace griffith::app
