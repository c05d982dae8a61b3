#include "app/output/video_writer.h"

#include <algorithm>
#include <csignal>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/output/file_formats.h"
#include "app/shared/processes.h"
#include "sim/core/error.h"
#include "sim/core/process.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

struct VideoFormat {
  const char* extension;
  const char* encoder;  ///< arguments of ffmpeg; odd sizes lose a row or column in favor of common players
};

constexpr VideoFormat kVideoFormats[] = {
    {".mp4", "-vf crop=trunc(iw/2)*2:trunc(ih/2)*2 -c:v libx264 -crf 17 -pix_fmt yuv420p -movflags +faststart"},
    {".mkv", "-vf crop=trunc(iw/2)*2:trunc(ih/2)*2 -c:v libx264 -crf 17 -pix_fmt yuv420p"},
    {".mov", "-vf crop=trunc(iw/2)*2:trunc(ih/2)*2 -c:v libx264 -crf 17 -pix_fmt yuv420p"},
    {".webm", "-c:v libvpx-vp9 -crf 24 -b:v 0 -row-mt 1 -pix_fmt yuva420p"},
    {".gif", "-vf split[a][b];[a]palettegen[p];[b][p]paletteuse"},
};

/// Splits a text at blanks.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string video_name(const fs::path& path) { return "video" + path.extension().string(); }

}  // namespace

bool is_video_path(const fs::path& path) {
  return std::ranges::any_of(kVideoFormats,
                             [&](const VideoFormat& format) { return path.extension() == format.extension; });
}

std::string video_extensions() { return extensions_text(kVideoFormats); }

void check_video_path(const fs::path& path) {
  format_of(kVideoFormats, path, "video extension");
  check_replaceable(path);
  constexpr ProcessLimits kLimits = {.seconds = 20, .memory_bytes = std::int64_t{4} << 30};
  if (!run_process({"ffmpeg", "-version"}, kLimits).succeeded())
    throw InputError(path.string(), "cannot be written: ffmpeg is missing",
                     "install it (Debian package ffmpeg), or write numbered pictures (.png)");
}

VideoWriter::VideoWriter(fs::path path, int width, int height, double frames_per_second) : path_(std::move(path)) {
  std::signal(SIGPIPE, SIG_IGN);  // if ffmpeg has ended, add() reports it
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  std::vector<std::string> words = {"ffmpeg",
                                    "-hide_banner",
                                    "-loglevel",
                                    "error",
                                    "-y",
                                    "-f",
                                    "rawvideo",
                                    "-pix_fmt",
                                    "rgba",
                                    "-s",
                                    size,
                                    "-r",
                                    std::to_string(frames_per_second),
                                    "-i",
                                    "-",
                                    "-an"};
  std::ranges::copy(words_of(format_of(kVideoFormats, path_).encoder), std::back_inserter(words));
  words.push_back((folder_.path() / video_name(path_)).string());
  const std::string command = shell_command(words) + " 2>" + shell_command({(folder_.path() / "log").string()});
  pipe_ = popen(command.c_str(), "we");
  if (!pipe_) throw std::runtime_error("ffmpeg could not be started");
}

VideoWriter::~VideoWriter() {
  if (pipe_) pclose(pipe_);
}

void VideoWriter::add(const render::Image& image) {
  if (folder_.termination_requested()) throw std::runtime_error("interrupted");
  if (std::fwrite(image.rgba.data(), 1, image.rgba.size(), pipe_) != image.rgba.size()) fail();
}

void VideoWriter::finish() {
  if (pclose(std::exchange(pipe_, nullptr)) != 0) fail();
  replace_file(path_, read_file(folder_.path() / video_name(path_)));
}

void VideoWriter::fail() const {
  std::string reason = read_file(folder_.path() / "log");
  while (!reason.empty() && reason.back() == '\n') reason.pop_back();
  throw std::runtime_error("ffmpeg could not write " + path_.string() + (reason.empty() ? "" : ": " + reason));
}

}  // namespace griffith::app
