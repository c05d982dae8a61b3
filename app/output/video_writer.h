#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "renderer/image.h"
#include "sim/core/temporary_folder.h"

namespace griffith::app {

/// Whether the ending is that of a video: .mp4, .mkv, .mov, .webm or .gif.
bool is_video_path(const std::filesystem::path& path);

/// Throws InputError where no video can be written there: no ending .mp4, .mkv, .mov, .webm or .gif, no ffmpeg, or a
/// folder that may not be written to.
void check_video_path(const std::filesystem::path& path);

/// Encodes pictures of one size into a video, by ffmpeg as a process of its own. The file appears when all is done.
class VideoWriter {
 public:
  /// `frames_per_second` > 0. Throws std::runtime_error when ffmpeg cannot be started.
  VideoWriter(std::filesystem::path path, int width, int height, double frames_per_second);
  /// Gives an unfinished video up.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Throws std::runtime_error, with what ffmpeg says, when it has ended.
  void add(const render::Image& image);
  /// Waits for ffmpeg and puts the file in its place. Throws std::runtime_error, with what ffmpeg says, when it fails.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  TemporaryFolder folder_;  ///< of the video being made, and of what ffmpeg says
  std::FILE* pipe_ = nullptr;
};

}  // namespace griffith::app
