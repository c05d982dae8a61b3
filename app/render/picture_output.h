#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/output/video_writer.h"
#include "app/render/contact_sheet.h"
#include "app/render/render_job.h"

namespace griffith::app {

/// Outputs of a run of pictures; empty ones are not written.
struct PictureOutput {
  std::filesystem::path folder;  ///< folder of PNG files, made if necessary, with the names of the pictures
  bool records = false;          ///< writes each picture's record (.json), text (.txt) and ids (.ids.png) too
  std::string renderer;          ///< name of the renderer, for the records
  std::filesystem::path contact_sheet;
  std::filesystem::path video;   ///< file name; several videos have cameras or views in their names
  double frames_per_second = 0;  ///< rate of the video; 0: real time
};

/// Writes pictures as they arrive.
class PictureWriter {
 public:
  /// `job`: job of the pictures. `time_step` [s].
  PictureWriter(PictureOutput output, const RenderJob& job, double time_step);

  void write(const RenderedPicture& picture);
  /// Finishes videos and draws the contact sheet. Needs the OpenGL context.
  void finish();

 private:
  void add_to_video(const RenderedPicture& picture);

  PictureOutput output_;
  RenderJob job_;
  double frames_per_second_;
  ContactSheet sheet_;
  std::map<std::filesystem::path, VideoWriter> videos_;
};

/// Returns the frame rate at which a video of these time steps runs in real time, 1 to 120; 30 for a turntable
/// or microsteps.
double frames_per_second(const RenderJob& job, double time_step);

/// Returns the record as JSON, with the state hash in hexadecimal. `renderer`: name of the renderer from OpenGL.
std::string record_json(const PictureRecord& record, const std::string& renderer);

}  // namespace griffith::app
