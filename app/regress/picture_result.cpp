#include "app/regress/picture_result.h"

#include <algorithm>
#include <array>

#include "app/output/id_picture.h"
#include "app/shared/hash_text.h"
#include "sim/core/number_text.h"
#include "sim/scene/scene_difference.h"

namespace griffith::app {
namespace {

using Row = PictureResult::Row;

/// Returns the metadata with the state's hash.
std::vector<std::pair<std::string, std::string>> all_metadata(const RegressionPicture& picture) {
  auto metadata = picture.metadata;
  if (picture.state_hash) metadata.emplace_back("state hash", hash_text(*picture.state_hash));
  return metadata;
}

std::vector<std::pair<std::string, std::string>> statistic_texts(const RegressionPicture& picture) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [name, value] : picture.statistics) texts.emplace_back(name, rounded_text(value, 10));
  return texts;
}

/// Pairs values by name in the order of the actual ones; names of the golden picture alone come last.
std::vector<Row> side_by_side(const std::vector<std::pair<std::string, std::string>>& golden,
                              const std::vector<std::pair<std::string, std::string>>& actual) {
  std::vector<Row> rows;
  for (const auto& [name, value] : actual) rows.push_back({name, {}, value});
  for (const auto& [name, value] : golden) {
    const auto row = std::ranges::find(rows, name, &Row::name);
    if (row == rows.end()) {
      rows.push_back({name, value, {}});
    } else {
      row->golden = value;
    }
  }
  return rows;
}

/// Scales an image to the size of a thumbnail.
render::Image thumbnail_of(const render::Image& image) {
  constexpr int kWidth = 192;
  if (image.width <= kWidth) return image;
  return render::resized(image, kWidth, std::max(1, image.height * kWidth / image.width));
}

/// Returns the tile that shows the difference best.
PixelRect tile_to_show(const ImageComparison& comparison) {
  return comparison.off.count > 0 ? comparison.off.worst_tile : comparison.drift_tile;
}

/// Returns up to 48×48 pixels around the center of the tile.
render::Image surroundings(const render::Image& image, const PixelRect& tile) {
  constexpr int kSide = 48;
  const int width = std::min(kSide, image.width), height = std::min(kSide, image.height);
  const int left = std::clamp(tile.left + tile.width / 2 - kSide / 2, 0, image.width - width);
  const int top = std::clamp(tile.top + tile.height / 2 - kSide / 2, 0, image.height - height);
  return render::part_of(image, left, top, width, height);
}

void keep_images(PictureResult& result, const RegressionPicture& golden, const RegressionPicture& actual,
                 const ImageTolerance& tolerance) {
  result.golden = render::encode_png(golden.image);
  result.actual = render::encode_png(actual.image);
  if (!golden.ids.ids.empty() && !actual.ids.ids.empty() && golden.ids != actual.ids) {
    result.golden_ids = render::encode_png(id_picture(golden.ids));
    result.actual_ids = render::encode_png(id_picture(actual.ids));
  }
  if (golden.image.width != actual.image.width || golden.image.height != actual.image.height) return;
  const render::Image difference = difference_image(golden.image, actual.image, tolerance);
  result.difference = render::encode_png(difference);
  if (result.image.equal) return;
  const PixelRect tile = tile_to_show(result.image);
  result.golden_tile = render::encode_png(surroundings(golden.image, tile));
  result.actual_tile = render::encode_png(surroundings(actual.image, tile));
  result.difference_tile = render::encode_png(surroundings(difference, tile));
}

/// Returns the result without the comparison.
PictureResult described(const std::string& name, const RegressionPicture& golden, const RegressionPicture& actual) {
  PictureResult result;
  result.name = name;
  result.metadata = side_by_side(all_metadata(golden), all_metadata(actual));
  result.statistics = side_by_side(statistic_texts(golden), statistic_texts(actual));
  result.thumbnail = render::encode_png(thumbnail_of(actual.image));
  return result;
}

/// Returns the fields in which the scenes differ, with long values truncated.
std::optional<std::vector<Row>> scene_rows(const RegressionPicture& golden, const RegressionPicture& actual) {
  if (golden.scene.empty() || actual.scene.empty()) return std::nullopt;
  const auto shortened = [](std::optional<std::string> value) {
    constexpr std::size_t kLength = 200;
    if (value && value->size() > kLength) value = value->substr(0, kLength) + " …";
    return value;
  };
  std::vector<Row> rows;
  for (const FieldChange& change : field_changes(golden.scene, actual.scene))
    rows.push_back({change.pointer.substr(std::min<std::size_t>(1, change.pointer.size())), shortened(change.before),
                    shortened(change.after)});
  return rows;
}

/// Describes the differences: "1 field of the scene changed, projectiles/0/speed: 10, now 12"; if there are many, the
/// first.
std::string scene_sentence(const std::vector<Row>& scene) {
  if (scene.empty()) return "No field of the scene changed; the program or a file of the scene did";
  const Row& first = scene.front();
  const auto text = [](const std::optional<std::string>& value) { return value.value_or("none"); };
  return std::to_string(scene.size()) + (scene.size() == 1 ? " field" : " fields") + " of the scene changed, " +
         (scene.size() == 1 ? "" : "first ") + first.name + ": " + text(first.golden) + ", now " + text(first.actual);
}

/// Returns what the job asks for that differs from the golden picture: "frame: 3, now 4"; empty if nothing does.
std::string job_changes(const std::vector<Row>& metadata) {
  std::string changes;
  for (const char* name : {"frame", "view", "camera"}) {
    const auto row = std::ranges::find(metadata, name, &Row::name);
    if (row == metadata.end() || row->golden == row->actual) continue;
    changes += (changes.empty() ? "" : "; ") + row->name + ": " + row->golden.value_or("none") + ", now " +
               row->actual.value_or("none");
  }
  return changes;
}

std::string reason_of(const PictureResult& result) {
  std::string reason;
  const auto add = [&](const std::string& sentence) { reason += (reason.empty() ? "" : " ") + sentence + "."; };
  const std::string job = job_changes(result.metadata);
  const bool simulation_changed = result.simulation_changed.value_or(false), same_job = job.empty();
  if (!same_job) add("The golden picture is of another job, " + job);
  if (simulation_changed && same_job) add("The simulation changed: the hash of its state differs");
  if (!result.image.passed && same_job && result.simulation_changed == std::optional(false))
    add("The simulation is identical; the drawing changed");
  if (result.scene && (!result.scene->empty() || (simulation_changed && same_job))) add(scene_sentence(*result.scene));
  add("Picture: " + result.image.reason);
  if (!result.ids.passed) add("Ids: " + result.ids.reason);
  const auto changed = std::ranges::count_if(result.text, [](const DiffLine& line) {
    return line.kind == DiffLine::Kind::removed || line.kind == DiffLine::Kind::added;
  });
  if (changed > 0)
    add("Text: " + std::to_string(changed) + (changed == 1 ? " line is" : " lines are") + " removed or added");
  return reason;
}

}  // namespace

const char* status_name(PictureStatus status) {
  constexpr std::array kNames = {"passed", "failed", "missing_golden", "error"};
  return kNames[static_cast<std::size_t>(status)];
}

PictureResult compare_pictures(const std::string& name, const RegressionPicture& golden,
                               const RegressionPicture& actual, const ImageTolerance& tolerance) {
  PictureResult result = described(name, golden, actual);
  result.image = compare_images(golden.image, actual.image, tolerance);
  const bool ids_known = !golden.ids.ids.empty() && !actual.ids.ids.empty();
  result.ids = ids_known ? compare_ids(golden.ids, actual.ids, tolerance.off) : IdComparison{true, "", {}, {}};
  result.text = compare_text(golden.text, actual.text);
  result.scene = scene_rows(golden, actual);
  if (golden.state_hash && actual.state_hash) result.simulation_changed = *golden.state_hash != *actual.state_hash;
  const bool complete = golden.ids.ids.empty() == actual.ids.ids.empty() &&
                        golden.state_hash.has_value() == actual.state_hash.has_value();
  const bool passed = complete && result.image.passed && result.ids.passed && result.text.empty() &&
                      !result.simulation_changed.value_or(false);
  result.status = passed ? PictureStatus::passed : PictureStatus::failed;
  result.reason = reason_of(result);
  if (!complete) result.reason = "One of the two lacks its ids or the state's hash: accept it again. " + result.reason;
  if (!passed) keep_images(result, golden, actual, tolerance);
  return result;
}

PictureResult without_golden(const std::string& name, const RegressionPicture& actual) {
  PictureResult result = described(name, {}, actual);
  result.status = PictureStatus::missing_golden;
  result.reason = "There is no golden picture. Look at this one and accept it if it is correct.";
  result.actual = render::encode_png(actual.image);
  return result;
}

PictureResult without_picture(const std::string& name, const std::string& error) {
  PictureResult result;
  result.name = name;
  result.reason = error;
  return result;
}

}  // namespace griffith::app
