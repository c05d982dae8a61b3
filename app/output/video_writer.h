#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "renderer/image.h"
#include "sim/core/temporary_folder.h"

namespace griffith::app {

/// Lists the extensions of videos: ".mp4, .mkv, .mov, .webm or .gif".
std::string video_extensions();
/// True for one of them.
bool is_video_path(const std::filesystem::path& path);

/// Throws InputError if no video can be written there: another extension, no ffmpeg, or a folder without write
/// permission.
void check_video_path(const std::filesystem::path& path);

/// Encodes pictures of one size into a video, with ffmpeg as a separate process. The file appears when it is complete.
class VideoWriter {
 public:
  /// `frames_per_second` > 0. Throws std::runtime_error if ffmpeg cannot be started.
  VideoWriter(std::filesystem::path path, int width, int height, double frames_per_second);
  /// Discards an unfinished video.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Adds a picture. Throws std::runtime_error with ffmpeg's message if it has ended.
  void add(const render::Image& image);
  /// Waits for ffmpeg and moves the file to its place. Throws std::runtime_error with ffmpeg's message if it fails.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  TemporaryFolder folder_;  ///< contains the unfinished video and ffmpeg's messages
  std::FILE* pipe_ = nullptr;
};

}  // namespace griffith::app
