#include "app/shared/shipped_thumbnails.h"

#include <set>

#include "app/shared/hash_text.h"
#include "app/shared/scene_files.h"
#include "renderer/error.h"
#include "sim/core/error.h"
#include "sim/core/hash_bytes.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

constexpr char kFolder[] = "thumbnails", kSuffix[] = ".jpg";
constexpr int kQuality = 85;
constexpr std::int64_t kMaxBytes = 1 << 20;

/// True if a file is named as the thumbnail of any version of that scene.
bool is_thumbnail_of(const fs::path& scene, const fs::path& file) {
  const std::string hash = file.stem().extension().string();
  return file.extension() == kSuffix && file.stem().stem() == scene.stem() && !hash.empty() &&
         hash_from_text(hash.substr(1));
}

}  // namespace

fs::path shipped_thumbnail_file(const fs::path& scene) {
  const std::string hash = hash_text(hash_bytes(read_file(scene)));
  return scene.parent_path() / kFolder / (scene.stem().string() + "." + hash + kSuffix);
}

std::optional<render::Image> shipped_thumbnail(const fs::path& scene) try {
  const fs::path file = shipped_thumbnail_file(scene);
  if (!is_taken(file)) return std::nullopt;
  return render::decode_image(read_file(file, kMaxBytes), kThumbnailWidth, kThumbnailHeight);
} catch (const InputError&) {
  return std::nullopt;
} catch (const render::RenderError&) {
  return std::nullopt;
}

void ship_thumbnail(const fs::path& scene, const render::Image& picture) {
  const fs::path file = shipped_thumbnail_file(scene);
  std::error_code error;  // if the folder cannot be made, writing reports it
  fs::create_directories(file.parent_path(), error);
  replace_file(file, render::encode_jpeg(picture, kQuality));
  for (const fs::path& other : files_in(file.parent_path()))
    if (other != file && is_thumbnail_of(scene, other)) fs::remove(other, error);
}

std::vector<fs::path> stale_thumbnails(const fs::path& folder) {
  std::set<fs::path> current;
  for (const fs::path& scene : scenes_in(folder)) current.insert(shipped_thumbnail_file(scene));
  std::vector<fs::path> stale = files_in(folder / kFolder);
  std::erase_if(stale, [&](const fs::path& file) { return current.contains(file); });
  return stale;
}

}  // namespace griffith::app
