#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/regress/compare_ids.h"
#include "app/regress/compare_images.h"
#include "app/regress/compare_text.h"

namespace griffith::app {

/// A picture and what explains it, as it was accepted or as it is drawn now.
struct RegressionPicture {
  render::Image image;
  render::IdImage ids;                      ///< what is drawn at each pixel; empty: not known
  std::string text;                         ///< what is written in it: labels, widgets and their values
  std::optional<std::uint64_t> state_hash;  ///< of the world that it shows
  std::string scene;                        ///< as full_scene_text() has it; empty: not kept
  std::vector<std::pair<std::string, std::string>> metadata;  ///< renderer, scene, frame, view, camera, version, ...
  std::vector<std::pair<std::string, double>> statistics;     ///< pieces, cracks, energies, ...
};

enum class PictureStatus { passed, failed, missing_golden, error };

/// "missing_golden", as reports call it.
const char* status_name(PictureStatus status);

/// What became of a picture, with what the report shows of it. Holds PNG files, not images, for there may be many.
struct PictureResult {
  std::string name;
  PictureStatus status = PictureStatus::error;
  std::string reason;                      ///< why, in whole sentences
  std::optional<bool> simulation_changed;  ///< by the state's hash; absent where either is not known
  ImageComparison image;
  IdComparison ids;
  std::vector<DiffLine> text;  ///< empty: equal
  // Bytes of PNG files; empty where there is none. Of a picture that passed the thumbnail alone is kept.
  std::string thumbnail, golden, actual, difference, golden_ids, actual_ids;
  std::string golden_tile, actual_tile, difference_tile;  ///< the worst tile with what surrounds it
  // Golden and actual, by their names; where one has no such name its value is absent.
  struct Row {
    std::string name;
    std::optional<std::string> golden, actual;
  };
  std::vector<Row> metadata, statistics;
  std::optional<std::vector<Row>> scene;  ///< fields that differ, by their pointers; absent where a scene is not kept
  std::string accept_command;             ///< makes the actual picture the golden one
  double seconds = 0;                     ///< that the picture took
};

/// Compares all that there is of a picture. It passes when the image and the ids are within the tolerance, the text is
/// the same and so is the simulation's state.
PictureResult compare_pictures(const std::string& name, const RegressionPicture& golden,
                               const RegressionPicture& actual, const ImageTolerance& tolerance = {});

/// Of a picture that nothing was accepted for.
PictureResult without_golden(const std::string& name, const RegressionPicture& actual);

/// Of a picture that could not be drawn or read.
PictureResult without_picture(const std::string& name, const std::string& error);

}  // namespace griffith::app
