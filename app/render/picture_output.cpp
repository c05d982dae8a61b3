#include "app/render/picture_output.h"

#include <griffith/version.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/output/id_picture.h"
#include "app/output/output.h"
#include "app/shared/hash_text.h"
#include "sim/core/replace_file.h"
#include "sim/scene/json_document.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

fs::path with_suffix(const fs::path& path, const std::string& suffix) {
  return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

/// Returns the part of a name after the job's if there are several cameras and views: "_front_utilization".
std::string viewpoint_suffix(const RenderJob& job, const PictureRecord& record) {
  RenderJob one_frame = job;
  one_frame.name = "x";
  one_frame.frames.resize(1);
  one_frame.turntable = one_frame.microsteps = 0;
  return picture_name(one_frame, record.camera, record.view, 0, false).substr(1);
}

/// Returns one row for each frame if a frame has several pictures.
int sheet_columns(const RenderJob& job) {
  constexpr std::size_t kMax = 8;
  const std::size_t count = job.cameras.size() * job.views.size();
  return count > 1 && count <= kMax ? static_cast<int>(count) : 0;
}

}  // namespace

PictureWriter::PictureWriter(PictureOutput output, const RenderJob& job, double time_step)
    : output_(std::move(output)),
      job_(job),
      frames_per_second_(output_.frames_per_second > 0 ? output_.frames_per_second
                                                       : app::frames_per_second(job, time_step)),
      sheet_(sheet_columns(job)) {}

void PictureWriter::write(const RenderedPicture& picture) {
  if (!output_.folder.empty()) {
    fs::create_directories(output_.folder);  // only now: a run that fails leaves no empty folder
    const fs::path stem = output_.folder / picture.name;
    save_picture(stem.string() + ".png", picture.image);
    if (output_.records) {
      replace_file(stem.string() + ".txt", picture.record.text);
      if (!picture.ids.ids.empty()) save_picture(stem.string() + ".ids.png", id_picture(picture.ids));
      // The record is written last, so that its presence means that the rest is complete.
      replace_file(stem.string() + ".json", record_json(picture.record, output_.renderer));
    }
  }
  if (!output_.contact_sheet.empty()) sheet_.add(picture.image, picture.name);
  if (!output_.video.empty()) add_to_video(picture);
}

void PictureWriter::finish() {
  for (auto& [path, video] : videos_) video.finish();
  if (!output_.contact_sheet.empty()) save_picture(output_.contact_sheet, sheet_.image(output_.contact_sheet.string()));
}

void PictureWriter::add_to_video(const RenderedPicture& picture) {
  const fs::path path = with_suffix(output_.video, viewpoint_suffix(job_, picture.record));
  const auto [video, is_new] = videos_.try_emplace(path, path, job_.width, job_.height, frames_per_second_);
  video->second.add(picture.image);
}

double frames_per_second(const RenderJob& job, double time_step) {
  constexpr double kMin = 1, kMax = 120, kWithinStep = 30;
  if (job.turntable > 0 || job.microsteps > 0) return kWithinStep;
  if (job.frames.size() < 2) return kMin;
  const double mean_interval =
      time_step * (job.frames.back() - job.frames.front()) / static_cast<double>(job.frames.size() - 1);
  return std::clamp(1 / mean_interval, kMin, kMax);
}

std::string record_json(const PictureRecord& record, const std::string& renderer) {
  Json json = {{"renderer", renderer}, {"version", GRIFFITH_VERSION}, {"frame", record.frame},
               {"view", record.view},  {"camera", record.camera},     {"state_hash", hash_text(record.state_hash)}};
  for (const auto& [name, value] : record.statistics) json["statistics"][name] = value;
  json["scene"] = Json::parse(record.scene);
  return pretty_text(json);
}

}  // namespace griffith::app
