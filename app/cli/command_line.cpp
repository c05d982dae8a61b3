#include "app/cli/command_line.h"

#include <griffith/version.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <new>

#include "app/output/output.h"
#include "app/shared/command_options.h"
#include "app/shared/scene_files.h"
#include "sim/core/error.h"
#include "sim/core/parallel.h"

namespace griffith::app {
namespace {

constexpr int kMaxFrames = 10'000'000, kMaxPixels = 16384, kMaxThreads = 1024;

struct Options {
  EditorOptions editor;
  RenderOptions render;
  SimulateOptions simulate;
  CheckOptions check;
  MeshOptions mesh;
  int threads = 0;  ///< 0: as many as the machine has
};

void add_threads(CLI::App& command, Options& options) {
  command.add_option("--threads", options.threads, "Threads to use; results do not depend on them")
      ->check(CLI::Range(1, kMaxThreads))
      ->type_name("T");
}

/// "1280x720" into two numbers.
std::string read_size(const std::string& text, RenderOptions& options) {
  char rest = 0;
  const bool good = std::sscanf(text.c_str(), "%dx%d%c", &options.width, &options.height, &rest) == 2;
  const auto possible = [](int pixels) { return pixels >= 16 && pixels <= kMaxPixels; };
  if (good && possible(options.width) && possible(options.height)) return {};
  return "--size: \"" + text + "\" is not a size: write WIDTHxHEIGHT, such as 1280x720, each from 16 to 16384";
}

void add_editor(CLI::App& program, Options& options) {
  program.add_option("SCENE", options.editor.scene, "Scene to open in the editor")->type_name("FILE");
  program.add_option("--exit-after", options.editor.exit_after)->check(CLI::Range(1, kMaxFrames))->group("");
  program.add_option("--screenshot", options.editor.screenshot)->group("");
  add_threads(program, options);
}

void add_render(CLI::App& program, Options& options) {
  CLI::App* command = program.add_subcommand("render", "Draw a scene into PNG files, without a window");
  RenderOptions& render = options.render;
  command->add_option("SCENE", render.scene, "Scene file")->required()->type_name("FILE");
  command->add_option("--frame", render.frame, "Time steps before the picture")
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command->add_option("-o,--output", render.output, "PNG file to write")->required()->type_name("FILE");
  command->add_option("--every", render.every, "A numbered picture every K steps, from 0 to N")
      ->check(CLI::Range(1, kMaxFrames))
      ->type_name("K");
  command
      ->add_option_function<std::string>(
          "--size",
          [&render](const std::string& text) {
            const std::string problem = read_size(text, render);
            if (!problem.empty()) throw CLI::ValidationError(problem);
          },
          "Size of the picture, 1280x720 if not given")
      ->type_name("WxH");
  command->add_option("--samples", render.samples, "Samples per pixel, 4 if not given; 1 has no smoothed edges")
      ->check(CLI::Range(1, 16))
      ->type_name("S");
  command
      ->add_option(
          "--view", render.view,
          "What to show: a quantity to colour by, a layer, wireframe, shrunken, exploded, slice or unlit; several "
          "joined by +, such as utilization+fracture_planes+slice. The scene's view if not given")
      ->type_name("NAME");
  command
      ->add_option("--node", render.node,
                   "Node that is explained, in text and by the views candidate_plane and element_forces; the most "
                   "loaded one if not given")
      ->check(CLI::Range(0, 1 << 30))
      ->type_name("N");
  command->add_option("--camera", render.camera, "Camera of the scene, the first if not given")->type_name("NAME");
  command->add_flag("--ui", render.interface, "Draw the editor's panels into the picture");
  command->add_flag("--legend,!--no-legend", render.legend, "Draw the legend of the colours; on if not given");
  command->add_option("--egl-device", render.egl_device, "Graphics device to use, as EGL counts them")
      ->check(CLI::Range(0, 64))
      ->type_name("N");
  add_threads(*command, options);
  command->footer(
      "Examples:\n"
      "  griffith render scenes/wall_small.json --frame 60 -o wall.png\n"
      "  griffith render scenes/wall_small.json --frame 240 --every 4 -o wall.png    wall_0000.png, wall_0004.png, "
      "...\n"
      "  griffith render scenes/wall_small.json --frame 30 --view utilization --size 1920x1080 -o utilization.png");
}

void add_simulate(CLI::App& program, Options& options) {
  CLI::App* command = program.add_subcommand("simulate", "Step a scene without any graphics");
  command->add_option("SCENE", options.simulate.scene, "Scene file")->required()->type_name("FILE");
  command->add_option("--frames", options.simulate.frames, "Time steps to make")
      ->required()
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command->add_option("--stats", options.simulate.stats, "Write what happened as JSON instead of a summary")
      ->type_name("FILE");
  command->add_option("--probes", options.simulate.probes, "Write the scene's probes as CSV, one row a time step")
      ->type_name("FILE");
  command->add_option("--energy", options.simulate.energy, "Write where the energy went as CSV, one row a time step")
      ->type_name("FILE");
  command
      ->add_option("--events", options.simulate.events,
                   "Write all crack events as JSON: place, plane, load, elements on both sides, bodies")
      ->type_name("FILE");
  command
      ->add_option("--export", options.simulate.export_file,
                   "Write the last time step as .vtu (ParaView) or .msh (Gmsh)")
      ->type_name("FILE");
  command
      ->add_option("--export-pieces", options.simulate.export_pieces,
                   "Write each body of the last time step as .obj into a folder, with its splinters if it has any")
      ->type_name("DIR");
  add_threads(*command, options);
  command->footer(
      "Examples:\n"
      "  griffith simulate scenes/wall_small.json --frames 600\n"
      "  griffith simulate scenes/brick_wall.json --frames 60 --export-pieces pieces\n"
      "  griffith simulate scenes/wall_small.json --frames 60 --export wall.vtu\n"
      "  griffith simulate scenes/cantilever.json --frames 1 --probes cantilever.csv\n"
      "  griffith simulate scenes/wall_small.json --frames 600 --threads 1 --stats wall.stats.json");
}

void add_check(CLI::App& program, Options& options) {
  CLI::App* command = program.add_subcommand("check", "List every problem of scene files");
  command->add_option("SCENE", options.check.scenes, "Scene files")->required()->type_name("FILE");
  command->footer("Example:\n  griffith check scenes/wall_small.json scenes/materials.json");
}

void add_mesh(CLI::App& program, Options& options) {
  CLI::App* command = program.add_subcommand("mesh", "Fill a surface with tetrahedra");
  MeshOptions& mesh = options.mesh;
  const std::map<std::string, MeshingMethod> methods = {{"automatic", MeshingMethod::automatic},
                                                        {"tetgen", MeshingMethod::tetgen},
                                                        {"volumetric", MeshingMethod::volumetric}};
  command->add_option("SURFACE", mesh.surface, "Surface: .obj, .stl, .ply, .off, .gltf or .glb")
      ->required()
      ->type_name("FILE");
  command->add_option("-o,--output", mesh.output, "Mesh to write: .msh, .vtu or .node")->required()->type_name("FILE");
  command
      ->add_option("--element-size", mesh.meshing.element_size,
                   "Edge of a tetrahedron [m]; 1/20 of the size if not given")
      ->check(CLI::Range(1e-6, 1e5))
      ->type_name("M");
  command
      ->add_option("--method", mesh.meshing.method,
                   "automatic (the default), tetgen (keeps the surface's triangles) or volumetric (takes any surface)")
      ->transform(CLI::CheckedTransformer(methods).description(""))
      ->type_name("NAME");
  command
      ->add_option("--grading", mesh.meshing.grading, "how many times longer edges may be deep inside; 1 if not given")
      ->check(CLI::Range(1.0, 100.0))
      ->type_name("G");
  command
      ->add_option("--quality", mesh.meshing.radius_edge_ratio,
                   "TetGen: most circumradius over shortest edge; 1.4 if not given")
      ->check(CLI::Range(1.1, 10.0))
      ->type_name("Q");
  command
      ->add_option("--min-dihedral", mesh.meshing.min_dihedral_angle,
                   "TetGen: angle between faces to work for; 10 if not given")
      ->check(CLI::Range(0.0, 18.0))
      ->type_name("DEGREES");
  command->add_option("--scale", mesh.scale, "Metres per unit of the file; 1 if not given")
      ->check(CLI::Range(1e-9, 1e6))
      ->type_name("S");
  command->add_option("--time-limit", mesh.time_limit, "TetGen: seconds; 300 if not given")
      ->check(CLI::Range(0.01, 1e6))
      ->type_name("S");
  command->add_option("--memory-limit", mesh.memory_limit, "TetGen: megabytes; 8192 if not given")
      ->check(CLI::Range(16, 1 << 20))
      ->type_name("MB");
  command->add_option("--report", mesh.report, "Write what was found and made as JSON")->type_name("FILE");
  command->add_flag("--cache,!--no-cache", mesh.cache, "Use meshes made before; on if not given");
  add_threads(*command, options);
  command->footer(
      "Examples:\n"
      "  griffith mesh vase.obj -o vase.msh\n"
      "  griffith mesh bunny.stl --scale 0.001 --element-size 0.005 --method volumetric -o bunny.vtu --report "
      "bunny.json");
}

/// Tells a slip in a command's name, which would be taken for a scene, from one in the name of a scene.
void require_scene(const std::filesystem::path& scene) {
  std::error_code error;
  if (scene.empty() || std::filesystem::exists(scene, error)) return;
  if (scene.has_extension() || scene.has_parent_path()) {
    const std::vector<std::filesystem::path> samples = scene_files("");
    std::string remedy = "check the path";
    if (!samples.empty()) remedy += "; scenes to begin with are in " + samples.front().parent_path().string();
    throw InputError(scene.string(), "there is no such scene file", remedy);
  }
  throw InputError(scene.string(), "is neither a command nor a scene file",
                   "the commands are render, simulate, check and mesh; --help describes them");
}

/// The message that CLI11 makes for --help, --version and bad usage; nothing where the arguments are good.
std::optional<int> parse(CLI::App& program, int argc, const char* const* argv, const Options& options) {
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ExtrasError& error) {
    if (program.get_subcommands().empty()) require_scene(options.editor.scene);
    program.exit(error);
    return kBadInput;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kBadInput;
  }
}

int dispatch(const CLI::App& program, Options& options) {
  std::unique_ptr<ThreadLimit> limit;
  if (options.threads > 0) limit = std::make_unique<ThreadLimit>(options.threads);
  if (program.got_subcommand("check")) return check_command(options.check) == 0 ? kDone : kBadInput;
  if (program.got_subcommand("simulate")) {
    options.simulate.threads = options.threads > 0 ? options.threads : default_thread_count();
    simulate_command(options.simulate);
  } else if (program.got_subcommand("render")) {
    render_command(options.render);
  } else if (program.got_subcommand("mesh")) {
    mesh_command(options.mesh);
  } else {
    require_scene(options.editor.scene);
    run_editor(options.editor);
  }
  return kDone;
}

/// Carries out what the arguments say; the exit code.
int obey(int argc, const char* const* argv) {
  Options options;
  CLI::App program("Griffith, a workbench for brittle fracture: opens SCENE in the editor, or carries out a command.",
                   "griffith");
  program.set_version_flag("--version", "griffith " GRIFFITH_VERSION);
  program.require_subcommand(0, 1);
  add_editor(program, options);
  add_render(program, options);
  add_simulate(program, options);
  add_check(program, options);
  add_mesh(program, options);
  program.footer(
      "Examples:\n  griffith scenes/wall_small.json\n  griffith render --help\n\n"
      "Exit code: 0 done, 1 the work failed, 2 bad usage, bad input or an output that cannot be written.");
  const std::optional<int> code = parse(program, argc, argv, options);
  return code ? *code : dispatch(program, options);
}

}  // namespace

int run(int argc, const char* const* argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the shell's limit is an error like a full disk
  try {
    const int code = obey(argc, argv);
    check_stdout();
    return code;
  } catch (const InputError& error) {
    explain(error);
    return kBadInput;
  } catch (const std::bad_alloc&) {
    std::fputs("griffith: the memory does not suffice\n  take larger elements or fewer bodies\n", stderr);
    return kFailed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "griffith: %s\n", error.what());
    return kFailed;
  }
}

}  // namespace griffith::app
