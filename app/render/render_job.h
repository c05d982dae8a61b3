#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/image.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Pictures of one run of a scene, without a window: each of some time steps through each camera in each view.
struct RenderJob {
  std::string name;  ///< in the names of pictures; empty: the scene file's
  std::filesystem::path scene;
  std::vector<int> frames = {0};  ///< time steps before the pictures, ascending
  // What stands for "as the scene says" is empty.
  std::vector<std::string> views = {""}, cameras = {""};
  int width = 1280, height = 720;         ///< [pixels]
  std::optional<int> samples;             ///< per pixel; absent: as the picture's quality has
  std::optional<PictureQuality> quality;  ///< absent: as the scene's view has
  std::optional<int> node;                ///< whose forces and plane are shown; the most loaded one if absent
  bool interface = false;                 ///< draw the editor's panels too
  bool open_sections = false;             ///< of the panels: all that can be folded
  std::vector<std::string> commands;      ///< names of the editor's commands to carry out before the first picture
  bool legend = true;
  bool transparent = false;  ///< neither sky nor ground; what shows nothing has alpha 0
};

/// What a picture shows and how the world was, as numbers and text.
struct PictureRecord {
  int frame = 0;
  std::string view, camera;  ///< empty: the scene's
  std::uint64_t state_hash = 0;
  std::vector<std::pair<std::string, double>> statistics;  ///< pieces, cracks, energies
  std::string scene;                                       ///< as full_scene_text() has it
  std::string text;  ///< a line for each thing written in the picture: legend and labels, or widgets and their values
};

/// A picture and what explains it.
struct RenderedPicture {
  std::string name;  ///< without folder and ending: "wall_front_utilization_0040"
  render::Image image;
  render::IdImage ids;  ///< of what is drawn at each pixel; empty with panels
  PictureRecord record;
};

/// Name of a picture of a job; camera, view and frame are part of it where the job has several, or `always_numbered`.
std::string picture_name(const RenderJob& job, const std::string& camera, const std::string& view, int frame,
                         bool always_numbered);

/// Names of all pictures of a job, in the order in which they are drawn; a single time step is no part of them.
std::vector<std::string> picture_names(const RenderJob& job);

/// Makes the run and hands each picture over: frame by frame, for each camera each view. Needs a current OpenGL
/// context. `always_numbered`: as above. Throws InputError for what the scene lacks: a camera, a view, a node. Returns
/// the explanation of job.node in the last frame; empty without one.
std::string render_job(const RenderJob& job, const Scene& scene, bool always_numbered,
                       const std::function<void(RenderedPicture)>& take);

}  // namespace griffith::app
