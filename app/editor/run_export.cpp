#include "app/editor/run_export.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>

#include "app/bake/run_baker.h"
#include "app/export/export_bake.h"
#include "app/output/video_writer.h"
#include "app/picture/picture_options.h"
#include "app/shared/scene_files.h"
#include "renderer/renderer.h"
#include "sim/core/low_priority.h"
#include "sim/core/monitor.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

bool is_pictures(const fs::path& path) { return path.extension() == ".png"; }

std::string of_steps(const char* doing, std::int64_t step, const Timeline& timeline) {
  return std::string(doing) + " step " + std::to_string(step) + " of " + std::to_string(timeline.last_step());
}

/// Numbers a path: "wall.png" becomes "wall_0012.png".
fs::path numbered(const fs::path& path, std::int64_t step) {
  std::array<char, 24> number;
  std::snprintf(number.data(), number.size(), "_%04lld.png", static_cast<long long>(step));
  return fs::path(path).replace_extension() += number.data();
}

std::string written_text(const fs::path& path, std::size_t frames) {
  return path.string() + ": " + std::to_string(frames) + (frames == 1 ? " frame" : " frames");
}

/// Data shared by both threads of a BakeExport.
struct BakeProgress {
  std::atomic<std::int64_t> step = 0;
  std::atomic<bool> cancelled = false;
};

/// Recomputes and bakes all steps, on a thread of its own.
std::string bake_and_write(Timeline timeline, const fs::path& path, BakeProgress& progress) {
  const Scene scene = timeline.world().scene();
  timeline.go_to(timeline.first_step());
  RunBaker baker(timeline.world().frame(), scene);
  for (std::int64_t step = timeline.first_step(); step <= timeline.last_step(); ++step) {
    if (progress.cancelled) throw Cancelled();
    timeline.go_to(step);
    baker.follow(timeline.world().frame());
    progress.step = step;
  }
  const Bake bake = baker.finish(timeline.world().frame());
  if (progress.cancelled) throw Cancelled();
  export_bake(path, bake);
  return written_text(path, bake.times.size());
}

class BakeExport : public RunExport {
 public:
  BakeExport(fs::path path, const Timeline& timeline) : last_step_(timeline.last_step()) {
    result_ = std::async(std::launch::async, [this, path = std::move(path), timeline]() mutable {
      const LowPriority background;
      return bake_and_write(std::move(timeline), path, progress_);
    });
  }
  ~BakeExport() override { progress_.cancelled = true; }

  std::optional<std::string> advance() override {
    if (result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    return result_.get();
  }
  std::string stage() const override {
    return "Baking step " + std::to_string(progress_.step) + " of " + std::to_string(last_step_);
  }
  std::string cancel() override {
    progress_.cancelled = true;
    try {
      return result_.get();
    } catch (const Cancelled&) {
      return {};
    }
  }
  bool in_background() const override { return true; }

 private:
  std::int64_t last_step_;
  BakeProgress progress_;
  std::future<std::string> result_;  ///< ends before the data of its thread
};

/// Draws one step in each call of advance().
class PictureExport : public RunExport {
 public:
  PictureExport(fs::path path, const Timeline& timeline, const EmbeddedDisplay& display, ExportedView view)
      : path_(std::move(path)), timeline_(timeline), display_(display), view_(std::move(view)) {
    scene_ = timeline_.world().scene();
    timeline_.go_to(timeline_.first_step());
    next_ = timeline_.step();
    const double rate = std::clamp(1 / scene_.simulation.time_step, 1.0, 120.0);
    if (is_video_path(path_)) video_.emplace(path_, view_.width, view_.height, rate);
  }

  std::optional<std::string> advance() override {
    if (next_ <= timeline_.last_step()) {
      timeline_.go_to(next_);
      write(picture());
      ++next_;
      return std::nullopt;
    }
    if (video_) video_->finish();
    return written_text(path_, static_cast<std::size_t>(next_ - timeline_.first_step()));
  }
  std::string stage() const override { return of_steps("Drawing", next_, timeline_); }
  std::string cancel() override {
    const std::int64_t pictures = next_ - timeline_.first_step();
    return video_ || pictures == 0 ? "" : written_text(path_, static_cast<std::size_t>(pictures));
  }

 private:
  render::Image picture() {
    const render::DrawScene drawn =
        draw_next_step(timeline_.world().frame(), display_, range_, scene_, view_.view, {}, view_.hidden);
    renderer_.render(drawn, view_.camera, picture_options(view_.width, view_.height, std::nullopt, view_.view));
    return renderer_.image();
  }

  void write(const render::Image& image) {
    if (video_) return video_->add(image);
    replace_file(numbered(path_, next_), render::encode_png(image));
  }

  fs::path path_;
  Timeline timeline_;
  CopyOnWrite<EmbeddedDisplay> display_;
  ExportedView view_;
  Scene scene_;
  render::Renderer renderer_;
  SteadyRange range_;
  std::optional<VideoWriter> video_;
  std::int64_t next_ = 0;
};

}  // namespace

fs::path file_in_the_way(const fs::path& path, const Timeline& timeline) {
  if (!is_pictures(path)) return path;
  for (std::int64_t step = timeline.first_step(); step <= timeline.last_step(); ++step)
    if (const fs::path picture = numbered(path, step); is_taken(picture)) return picture;
  return path;
}

std::vector<std::string> export_hints() {
  std::vector<std::string> lines = bake_hints();
  lines.emplace_back("The view: .mp4, .webm, .gif (with ffmpeg), .png (one picture per step)");
  return lines;
}

void check_export(const fs::path& path) {
  if (is_video_path(path)) return check_video_path(path);
  if (!is_pictures(path)) check_bake_path(path);
  check_replaceable(path);
}

std::unique_ptr<RunExport> start_export(const fs::path& path, const Timeline& timeline, const EmbeddedDisplay& display,
                                        const ExportedView& view) {
  check_export(path);
  if (is_video_path(path) || is_pictures(path)) return std::make_unique<PictureExport>(path, timeline, display, view);
  return std::make_unique<BakeExport>(path, timeline);
}

}  // namespace griffith::app
