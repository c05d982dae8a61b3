#include "app/editor/thumbnail_maker.h"

#include <griffith/version.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>

#include "app/shared/hash_text.h"
#include "app/shared/shipped_thumbnails.h"
#include "renderer/error.h"
#include "sim/core/error.h"
#include "sim/core/hash_bytes.h"
#include "sim/core/low_priority.h"
#include "sim/core/process.h"
#include "sim/core/read_file.h"
#include "sim/meshing/mesh_cache.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// Changes whenever thumbnails of this version must be redrawn.
constexpr char kThumbnailFormat[] = "griffith thumbnail 2 " GRIFFITH_VERSION "\n";
/// Memory is practically unlimited: drivers reserve far more address space than they use.
constexpr ProcessLimits kThumbnailLimits = {.seconds = 120, .memory_bytes = std::int64_t{1} << 40};

/// Reads the picture in a file. Returns nothing if the file is missing or holds no picture.
std::optional<render::Image> kept_thumbnail(const fs::path& entry) try {
  return render::load_png(entry);
} catch (const render::RenderError&) {
  return std::nullopt;
}

/// Reads the thumbnail that ships with the scene, or else the cached one.
std::optional<render::Image> existing_thumbnail(const fs::path& scene, const fs::path& folder) try {
  if (std::optional<render::Image> picture = shipped_thumbnail(scene)) return picture;
  return folder.empty() ? std::nullopt : kept_thumbnail(thumbnail_entry(folder, scene));
} catch (const InputError&) {
  return std::nullopt;  // it cannot be read
}

void draw_thumbnail(const fs::path& program, const fs::path& scene, const fs::path& entry,
                    const std::function<bool()>& cancelled) {
  std::error_code ignored;
  fs::create_directories(entry.parent_path(), ignored);
  run_process({"nice", program, "thumbnail", scene, "-o", entry, "--threads", "1"}, kThumbnailLimits, {}, cancelled);
}

}  // namespace

/// Data shared by both threads.
struct ThumbnailMaker::Shared {
  std::atomic<bool> cancelled = false;
  std::mutex mutex;
  std::deque<Made> made;  ///< under `mutex`

  void add(std::size_t scene, render::Image picture) {
    const std::lock_guard lock(mutex);
    made.push_back({scene, std::move(picture)});
  }
};

fs::path thumbnail_cache() {
  const fs::path folder = default_mesh_cache();
  return folder.empty() ? folder : folder / "thumbnails";
}

fs::path thumbnail_entry(const fs::path& folder, const fs::path& scene) {
  return folder / (hash_text(hash_bytes(read_file(scene), hash_bytes(kThumbnailFormat))) + ".png");
}

void ThumbnailMaker::make_all(const std::vector<fs::path>& scenes, const ThumbnailSource& source, Shared& shared) {
  const auto cancelled = [&] { return shared.cancelled.load(); };
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < scenes.size() && !cancelled(); ++i) {
    std::optional<render::Image> picture = existing_thumbnail(scenes[i], source.folder);
    if (!picture) missing.push_back(i);
    if (picture) shared.add(i, std::move(*picture));
  }
  if (source.program.empty() || source.folder.empty()) return;
  for (const std::size_t i : missing) {
    if (cancelled()) return;
    try {
      const fs::path entry = thumbnail_entry(source.folder, scenes[i]);
      draw_thumbnail(source.program, scenes[i], entry, cancelled);
      if (std::optional<render::Image> picture = kept_thumbnail(entry)) shared.add(i, std::move(*picture));
    } catch (const std::runtime_error&) {
      // The card of an unreadable scene shows the error; a picture that cannot be drawn is left out.
    }
  }
}

ThumbnailMaker::ThumbnailMaker(std::vector<fs::path> scenes, ThumbnailSource source)
    : shared_(std::make_shared<Shared>()) {
  work_ = std::async(std::launch::async, [scenes = std::move(scenes), source = std::move(source), shared = shared_] {
    const LowPriority background;
    make_all(scenes, source, *shared);
  });
}

ThumbnailMaker::~ThumbnailMaker() { shared_->cancelled = true; }

std::optional<ThumbnailMaker::Made> ThumbnailMaker::take() {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->made.empty()) return std::nullopt;
  Made first = std::move(shared_->made.front());
  shared_->made.pop_front();
  return first;
}

bool ThumbnailMaker::done() const {
  if (work_.valid() && work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  const std::lock_guard lock(shared_->mutex);
  return shared_->made.empty();
}

}  // namespace griffith::app
