#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/meshing/meshing_options.h"

namespace griffith::app {

/// The editor in a window.
struct EditorOptions {
  std::filesystem::path scene;       ///< empty: a scene to start with
  int exit_after = 0;                ///< pictures after which the program ends by itself; 0: never
  std::filesystem::path screenshot;  ///< written at that end, if not empty
};

/// Pictures without a window.
struct RenderOptions {
  std::filesystem::path scene, output;
  int frame = 0;                   ///< steps before the (last) picture
  int every = 0;                   ///< a picture each so many steps from 0 on, numbered; 0: one picture
  int width = 1280, height = 720;  ///< [pixels]
  int samples = 4;                 ///< per pixel
  std::string view, camera;        ///< empty: the scene's
  std::optional<int> node;         ///< whose forces and plane are shown; the most loaded one if absent
  bool interface = false;          ///< draw the editor's panels too
  bool legend = true;
  std::optional<int> egl_device;
};

/// Steps without pictures.
struct SimulateOptions {
  std::filesystem::path scene;
  int frames = 0;
  std::filesystem::path stats;          ///< empty: a summary on stdout
  std::filesystem::path probes;         ///< empty: the scene's probes are not written down
  std::filesystem::path energy;         ///< CSV of the energy account; empty: none
  std::filesystem::path events;         ///< JSON of all crack events; empty: none
  std::filesystem::path export_file;    ///< .vtu or .msh of the last frame; empty: none
  std::filesystem::path export_pieces;  ///< folder for the last frame's bodies as .obj; empty: none
  int threads = 1;                      ///< in use, for the report
};

struct CheckOptions {
  std::vector<std::filesystem::path> scenes;
};

/// A surface to be filled with tets.
struct MeshOptions {
  std::filesystem::path surface, output;
  MeshingOptions meshing;
  double scale = 1;                  ///< metres per unit of the file
  double time_limit = 300;           ///< of TetGen [s]
  std::int64_t memory_limit = 8192;  ///< of TetGen [MB]
  bool cache = true;                 ///< use meshes made before
  std::filesystem::path report;      ///< JSON; empty: none
};

/// Opens the window and returns when it is closed. Throws std::runtime_error when there is no display.
void run_editor(const EditorOptions& options);
/// Throws InputError for a bad scene, quantity, camera or output, RenderError when there are no graphics.
void render_command(const RenderOptions& options);
/// Throws InputError for a bad scene, when probes are asked for that the scene does not have, and for an export file of
/// another kind than .vtu or .msh.
void simulate_command(const SimulateOptions& options);
/// Prints every problem of every scene, and warnings; returns how many problems there are.
int check_command(const CheckOptions& options);
/// Throws InputError for a bad surface, when it cannot be filled and for an output file of another kind than .msh, .vtu
/// or .node.
void mesh_command(const MeshOptions& options);

}  // namespace griffith::app
