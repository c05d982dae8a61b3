#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/output/video_writer.h"
#include "app/render/contact_sheet.h"
#include "app/render/render_job.h"

namespace griffith::app {

/// Where the pictures of a run go. What is empty is not written.
struct PictureOutput {
  std::filesystem::path folder;  ///< of PNG files, made if need be; named as the pictures are
  bool records = false;          ///< beside each PNG file its record (.json), text (.txt) and ids (.ids.png)
  std::string renderer;          ///< what draws the pictures, for the records
  std::filesystem::path contact_sheet;
  std::filesystem::path video;   ///< with cameras or views in its name where there are several
  double frames_per_second = 0;  ///< of the video; 0: as fast as time passes
};

/// Writes pictures as they come.
class PictureWriter {
 public:
  /// `job`: whose pictures come. `time_step` [s].
  PictureWriter(PictureOutput output, const RenderJob& job, double time_step);

  void write(const RenderedPicture& picture);
  /// Ends videos and draws the contact sheet. Needs the OpenGL context.
  void finish();

 private:
  void add_to_video(const RenderedPicture& picture);

  PictureOutput output_;
  RenderJob job_;
  double frames_per_second_;
  ContactSheet sheet_;
  std::map<std::filesystem::path, VideoWriter> videos_;
};

/// Frames a second with which a video of these time steps runs as fast as time passes, from 1 to 120.
double frames_per_second(const RenderJob& job, double time_step);

/// The record as JSON, the state hash in hexadecimal. `renderer`: what drew the picture, as OpenGL calls it.
std::string record_json(const PictureRecord& record, const std::string& renderer);

}  // namespace griffith::app
