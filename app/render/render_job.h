#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/picture/large_picture.h"
#include "renderer/image.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// Pictures of one run of a scene: time steps times cameras times views times angles of a turntable.
struct RenderJob {
  std::string name;  ///< prefix of the names of pictures; empty: the scene file's
  std::filesystem::path scene;
  std::vector<int> frames = {0};  ///< time steps before the pictures, ascending
  // Empty: from the scene.
  std::vector<std::string> views = {""}, cameras = {""};
  int turntable = 0;                      ///< pictures around the camera's target in place of one; 0: none
  int microsteps = 0;                     ///< pictures of microsteps of the last step in place of one; 0: none
  int width = 1280, height = 720;         ///< [pixels]
  int largest_part = kLargestPart;        ///< largest side of what is drawn at once [pixels]
  std::optional<int> samples;             ///< per pixel; absent: by quality
  std::optional<PictureQuality> quality;  ///< absent: from the scene's view
  bool poster = false;                    ///< with depth of field and motion blur, without legend and labels
  std::optional<int> node;                ///< node whose forces and plane are shown; absent: the most loaded one
  bool interface = false;                 ///< draws the editor's panels too
  bool open_sections = false;             ///< unfolds all sections of the panels
  std::vector<std::string> commands;      ///< commands of the editor before the first picture
  bool sky = false;                       ///< surroundings: a clear sky in place of the studio
  bool legend = true;
  bool transparent = false;  ///< neither sky nor ground; empty pixels have alpha 0
};

/// Names of qualities for set_quality(): those of views and "poster".
std::vector<std::string> quality_names();

/// Sets the quality of the pictures by its name.
void set_quality(RenderJob& job, std::string_view name);

/// Numbers and texts about a picture and the state of its world.
struct PictureRecord {
  int frame = 0;
  std::string view, camera;  ///< empty: from the scene
  std::uint64_t state_hash = 0;
  std::vector<std::pair<std::string, double>> statistics;  ///< pieces, cracks, energies
  std::string scene;                                       ///< from full_scene_text()
  std::string text;  ///< one line for each text in the picture: legend and labels, or widgets and their values
};

/// A picture with its record.
struct RenderedPicture {
  std::string name;  ///< without folder and extension: "wall_front_utilization_0040"
  render::Image image;
  render::IdImage ids;  ///< object at each pixel; empty with panels
  PictureRecord record;
};

/// Returns the name of a picture of a job. Camera, view and frame are parts of it if the job has several, or with
/// `always_numbered`, and `turn` if it has a turntable or microsteps.
std::string picture_name(const RenderJob& job, const std::string& camera, const std::string& view, int frame,
                         bool always_numbered, int turn = 0);

/// Returns the number of pictures of a job without microsteps.
std::size_t picture_count(const RenderJob& job);

/// Most pictures of a turntable, or of the microsteps of a step.
inline constexpr int kMaxTurntable = 3600, kMaxMicrosteps = 3600;

/// Returns the names of all pictures of a job without microsteps in drawing order; a single time step is no part of
/// them.
std::vector<std::string> picture_names(const RenderJob& job);

/// Makes the run and passes each picture to the callback: for each frame and camera every view, from every angle. Needs
/// a current OpenGL context. `always_numbered`: as above. Throws InputError if the scene lacks a camera, view or node,
/// or a step microsteps.
/// Returns the explanation of job.node in the last frame; empty without one.
std::string render_job(const RenderJob& job, const Scene& scene, bool always_numbered,
                       const std::function<void(RenderedPicture)>& take);

}  // namespace griffith::app
