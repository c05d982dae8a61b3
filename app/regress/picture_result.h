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

/// A golden or newly drawn picture with its record.
struct RegressionPicture {
  render::Image image;
  render::IdImage ids;                                        ///< id at each pixel; empty: unknown
  std::string text;                                           ///< text in the picture: labels, widgets and their values
  std::optional<std::uint64_t> state_hash;                    ///< hash of the shown world
  std::string scene;                                          ///< from full_scene_text(); empty: not kept
  std::vector<std::pair<std::string, std::string>> metadata;  ///< renderer, scene, frame, view, camera, version, ...
  std::vector<std::pair<std::string, double>> statistics;     ///< pieces, cracks, energies, ...
};

enum class PictureStatus { passed, failed, missing_golden, error };

/// Returns the name of a status in reports: "missing_golden".
const char* status_name(PictureStatus status);

/// Result of a picture with the content of the report. Holds PNG files instead of images, since there may be many.
struct PictureResult {
  std::string name;
  PictureStatus status = PictureStatus::error;
  std::string reason;                      ///< reason in complete sentences
  std::optional<bool> simulation_changed;  ///< by the state's hash; absent if either is unknown
  ImageComparison image;
  IdComparison ids;
  std::vector<DiffLine> text;  ///< empty: equal
  // Bytes of PNG files; empty if there is none. A passed picture keeps only its thumbnail.
  std::string thumbnail, golden, actual, difference, golden_ids, actual_ids;
  std::string golden_tile, actual_tile, difference_tile;  ///< worst tile with its surroundings
  // Golden and actual value of a name; absent values have no entry on that side.
  struct Row {
    std::string name;
    std::optional<std::string> golden, actual;
  };
  std::vector<Row> metadata, statistics;
  std::optional<std::vector<Row>> scene;  ///< fields that differ, by their pointers; absent if a scene is not kept
  std::string accept_command;             ///< accepts the actual picture as golden
  double seconds = 0;                     ///< duration of drawing
};

/// Compares a picture with its golden one. It passes if image and ids are within the tolerance and text and state of
/// the simulation are equal.
PictureResult compare_pictures(const std::string& name, const RegressionPicture& golden,
                               const RegressionPicture& actual, const ImageTolerance& tolerance = {});

/// Returns the result of a picture without a golden one.
PictureResult without_golden(const std::string& name, const RegressionPicture& actual);

/// Returns the result of a picture that could not be drawn or read.
PictureResult without_picture(const std::string& name, const std::string& error);

}  // namespace griffith::app
