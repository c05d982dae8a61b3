#include "app/editor/view_render.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <mutex>
#include <numbers>

#include "app/output/output.h"
#include "app/output/video_writer.h"
#include "app/picture/exposure.h"
#include "app/picture/large_picture.h"
#include "app/picture/picture_options.h"
#include "app/shared/processes.h"
#include "app/shared/scene_files.h"
#include "sim/core/error.h"
#include "sim/core/low_priority.h"
#include "sim/core/monitor.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ui::RenderedSubject;

/// Numbers a picture of a turntable: "vase.png" becomes "vase_012.png".
fs::path of_turn(const fs::path& path, int turn) {
  char number[16];
  std::snprintf(number, sizeof number, "_%03d", turn);
  return path.parent_path() / (path.stem().string() + number + path.extension().string());
}

int picture_count(const ui::RenderRequest& request) {
  return request.subject == RenderedSubject::turntable ? request.pictures : 1;
}

/// Returns the file of a picture.
fs::path picture_file(const fs::path& path, const ui::RenderRequest& request, int turn) {
  return request.subject == RenderedSubject::turntable ? of_turn(path, turn) : path;
}

void check_output(const fs::path& path, const ui::RenderRequest& request) {
  if (!is_possible_size(request.width, request.height))
    throw InputError("render", "cannot draw " + std::to_string(request.width) + "x" + std::to_string(request.height),
                     "use at most 400 million pixels");
  if (request.subject == RenderedSubject::turntable && is_video_path(path)) return check_video_path(path);
  if (path.extension() != ".png")
    throw InputError(path.string(), "is not the name of a picture",
                     request.subject == RenderedSubject::turntable ? "use .png, or for a video " + video_extensions()
                                                                   : "use the extension .png");
  check_replaceable(picture_file(path, request, 0));
}

/// Draws one picture in each call of advance().
class ViewRender : public RunExport {
 public:
  ViewRender(fs::path path, const ui::RenderRequest& request, const RenderedStep& step)
      : path_(std::move(path)),
        request_(request),
        world_(step.world),
        scene_(step.scene),
        display_(step.display),
        range_(step.range),
        camera_(render::contain(step.camera, step.aspect,
                                static_cast<float>(request.width) / static_cast<float>(request.height))),
        view_(step.view),
        hidden_(step.hidden) {
    constexpr double kRate = 30;
    if (request.poster) {
      exposures_ = exposures(kPosterExposures, kPosterTimes);
      view_.quality = PictureQuality::high;
    }
    if (is_video_path(path_)) video_.emplace(path_, request.width, request.height, kRate);
  }

  std::optional<std::string> advance() override {
    if (!announced_) {  // the dialog shows what is drawn
      announced_ = true;
      return std::nullopt;
    }
    if (request_.poster && !expose()) return std::nullopt;
    write(request_.poster ? std::exchange(sum_, {}).mean() : drawn(world_.frame(), camera()));
    if (++next_ < picture_count(request_)) return std::nullopt;
    if (video_) video_->finish();
    return text_of_written();
  }
  std::string stage() const override {
    const std::string exposure =
        request_.poster ? ", exposure " + std::to_string(exposed_ + 1) + " of " + std::to_string(kPosterExposures) : "";
    return "Drawing picture " + std::to_string(next_ + 1) + " of " + std::to_string(picture_count(request_)) + exposure;
  }
  std::string cancel() override { return video_ || next_ == 0 ? "" : text_of_written(); }

 private:
  /// Returns the camera of the next picture.
  render::Camera camera() const {
    const double turn = 2 * std::numbers::pi * next_ / picture_count(request_);
    return next_ == 0 ? camera_ : render::orbit(camera_, static_cast<float>(turn), 0);
  }

  render::Image drawn(const Frame& frame, const render::Camera& camera) {
    return large_picture(renderer_, draw_scene_from_frame(frame, display_, scene_, view_, {}, range_, hidden_), camera,
                         picture_options(request_.width, request_.height, std::nullopt, view_));
  }

  /// Adds an exposure to the next picture. True if it was the last one.
  bool expose() {
    const Exposure& exposure = exposures_[exposed_];
    const LaterFrame later(world_.frame(), kShutter * scene_.simulation.time_step * exposure.time);
    sum_.add(drawn(later.frame(), exposed(camera(), exposure, request_.height)));
    exposed_ = (exposed_ + 1) % exposures_.size();
    return exposed_ == 0;
  }

  void write(const render::Image& image) {
    if (video_) return video_->add(image);
    replace_file(picture_file(path_, request_, next_), render::encode_png(image));
  }

  std::string text_of_written() const {
    return path_.string() + (next_ == 1 ? "" : ": " + std::to_string(next_) + " pictures");
  }

  fs::path path_;
  ui::RenderRequest request_;
  World world_;
  Scene scene_;
  EmbeddedDisplay display_;
  std::optional<Vec2> range_;
  render::Camera camera_;
  ViewSettings view_;
  HiddenBodies hidden_;
  render::Renderer renderer_;
  std::optional<VideoWriter> video_;
  std::vector<Exposure> exposures_;  ///< exposures of each picture of a poster; else none
  std::size_t exposed_ = 0;          ///< number of those of the next picture so far
  ImageSum sum_;                     ///< their sum
  bool announced_ = false;
  int next_ = 0;
};

/// Line that another thread writes.
class SharedLine {
 public:
  void set(const std::string& text) {
    const std::lock_guard lock(mutex_);
    text_ = text;
  }
  std::string get() const {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  mutable std::mutex mutex_;
  std::string text_;
};

class BatchRender : public RunExport {
 public:
  BatchRender(const fs::path& scenes, fs::path pictures, const ui::RenderRequest& request)
      : pictures_(std::move(pictures)) {
    const std::string size = std::to_string(request.width) + "x" + std::to_string(request.height);
    std::vector<std::string> command = {
        this_program(), "render", scenes.string(),   "--frame", std::to_string(request.step), "--size",
        size,           "-o",     pictures_.string()};
    if (request.poster) command.insert(command.end(), {"--quality", "poster"});
    result_ = std::async(std::launch::async, [this, command] {
      const LowPriority background;
      return run(command);
    });
  }
  ~BatchRender() override { cancelled_ = true; }

  std::optional<std::string> advance() override {
    if (result_.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) return std::nullopt;
    return result_.get();
  }
  std::string stage() const override { return "Drawing " + line_.get(); }
  std::string cancel() override {
    cancelled_ = true;
    result_.wait();
    return {};
  }
  bool in_background() const override { return true; }

 private:
  std::string run(const std::vector<std::string>& command) {
    constexpr ProcessLimits kLimits = {.seconds = 1e6, .memory_bytes = std::int64_t{1} << 40};
    const ProcessOutcome outcome = run_process(
        command, kLimits, [&](const std::string& line) { line_.set(line); }, [&] { return cancelled_.load(); });
    if (cancelled_) return {};
    if (outcome.succeeded()) return pictures_.string();
    throw InputError("some scenes", "could not be drawn: " + failure_text(outcome, kLimits),
                     "griffith check lists the problems of a scene; the others are in " + pictures_.string());
  }

  fs::path pictures_;
  SharedLine line_;
  std::atomic<bool> cancelled_ = false;
  std::future<std::string> result_;  ///< ends before the data of its thread
};

}  // namespace

std::unique_ptr<RunExport> start_render(const fs::path& path, const ui::RenderRequest& request,
                                        const RenderedStep& step) {
  check_output(path, request);
  return std::make_unique<ViewRender>(path, request, step);
}

std::unique_ptr<RunExport> start_batch(const fs::path& scenes, const fs::path& pictures,
                                       const ui::RenderRequest& request) {
  if (!is_possible_size(request.width, request.height)) check_output(pictures, request);
  check_folder(pictures);
  return std::make_unique<BatchRender>(scenes, pictures, request);
}

fs::path file_in_the_way(const fs::path& path, const ui::RenderRequest& request) {
  if (request.subject != RenderedSubject::turntable || is_video_path(path)) return path;
  for (int turn = 0; turn < request.pictures; ++turn)
    if (const fs::path picture = of_turn(path, turn); is_taken(picture)) return picture;
  return path;
}

}  // namespace griffith::app
