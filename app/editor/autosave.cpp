#include "app/editor/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

constexpr char kScene[] = "scene.json", kOrigin[] = "origin";
constexpr char kMark[] = "edits-";

fs::path prefix_beside(const fs::path& file) {
  return fs::absolute(file).parent_path() / ("." + file.filename().string() + "." + kMark);
}

/// The link in `states` to a copy beside a scene.
fs::path link_to(const fs::path& copy, const fs::path& states) {
  const std::string name = copy.filename().string();
  return states / name.substr(name.rfind(kMark));
}

void remove_copy(const LockedFolder& copy, const fs::path& states) {
  std::error_code ignored;
  if (const fs::path link = link_to(copy.path(), states); fs::is_symlink(link, ignored)) fs::remove(link, ignored);
  fs::remove_all(copy.path(), ignored);
}

/// What stands in `folder` under a name that begins like `prefix`'s; links are followed, broken
/// ones removed, save where the folder of the copy is away: a drive that is not there now.
void collect(const fs::path& prefix, std::vector<fs::path>& copies) {
  std::error_code error;
  for (fs::directory_iterator entry(prefix.parent_path(), error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->path().filename().string().starts_with(prefix.filename().string())) continue;
    std::error_code ignored;
    const fs::path copy = entry->is_symlink(ignored) ? fs::read_symlink(entry->path(), ignored) : entry->path();
    if (fs::is_regular_file(copy / kScene, ignored)) {
      copies.push_back(copy);
    } else if (entry->is_symlink(ignored) && fs::is_directory(copy.parent_path(), ignored)) {
      fs::remove(entry->path(), ignored);
    }
  }
}

fs::file_time_type time_of(const fs::path& copy) {
  std::error_code ignored;
  return fs::last_write_time(copy / kScene, ignored);
}

/// The scene file that a copy is of; empty when it had none.
fs::path origin_of(const fs::path& copy) {
  std::ifstream stream(copy / kOrigin, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.empty() ? fs::path() : (copy / text).lexically_normal();
}

}  // namespace

LockedFolder LockedFolder::make(const fs::path& prefix) {
  std::string path = prefix.string() + "XXXXXX";
  if (mkdtemp(path.data())) {
    if (std::optional<LockedFolder> folder = take(path)) return std::move(*folder);
    rmdir(path.c_str());
  }
  throw InputError(prefix.parent_path().string(), "takes no copy of the edits that are not saved",
                   "save the scene in a folder that may be written to");
}

std::optional<LockedFolder> LockedFolder::take(const fs::path& path) {
  Descriptor lock(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat status;
  const bool mine = lock.is_open() && fstat(lock.number(), &status) == 0 && status.st_uid == geteuid();
  if (!mine || flock(lock.number(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return LockedFolder(path, std::move(lock));
}

void Autosave::write(const Scene& scene, const fs::path& file) {
  std::error_code ignored;
  if (own_ && (own_file_ != file || !fs::is_directory(own_->path(), ignored))) remove();
  if (!own_) begin_copy(file);
  write_scene(scene, own_->path() / kScene);
  // Only now: others remove links to copies that hold nothing.
  if (!file.empty() && !states_.empty())
    fs::create_directory_symlink(own_->path(), link_to(own_->path(), states_), ignored);
}

void Autosave::begin_copy(const fs::path& file) {
  if (file.empty() && states_.empty())
    throw InputError("the edits", "are copied nowhere until the scene is saved",
                     "set HOME or XDG_STATE_HOME, or save it");
  std::error_code ignored;
  if (!states_.empty()) fs::create_directories(states_, ignored);
  LockedFolder copy = LockedFolder::make(file.empty() ? states_ / kMark : prefix_beside(file));
  try {
    replace_file(copy.path() / kOrigin, file.empty() ? "" : "../" + file.filename().string());
  } catch (const InputError&) {
    remove_copy(copy, states_);
    throw;
  }
  own_ = std::move(copy);
  own_file_ = file;
}

void Autosave::remove() {
  if (own_) remove_copy(*own_, states_);
  own_.reset();
}

bool Autosave::find(const fs::path& file) {
  std::vector<fs::path> copies;
  if (!file.empty()) collect(prefix_beside(file), copies);
  return take_newest(std::move(copies));
}

bool Autosave::find_any(const fs::path& file) {
  std::vector<fs::path> copies;
  if (!states_.empty()) collect(states_ / kMark, copies);
  if (!file.empty()) collect(prefix_beside(file), copies);
  return take_newest(std::move(copies));
}

bool Autosave::take_newest(std::vector<fs::path> copies) {
  std::ranges::stable_sort(copies, std::greater(), time_of);
  found_.reset();
  for (const fs::path& copy : copies)
    if (!found_) found_ = LockedFolder::take(copy);
  return found_.has_value();
}

std::string Autosave::found_text() const {
  const fs::path origin = origin_of(found_->path());
  const auto time = std::chrono::file_clock::to_sys(time_of(found_->path()));
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::time_point_cast<std::chrono::system_clock::duration>(time));
  std::tm local;
  char text[64] = "";
  if (localtime_r(&seconds, &local)) std::strftime(text, sizeof text, "%e %B, %H:%M", &local);
  return (origin.empty() ? std::string("a new scene") : origin.string()) + ", " + text;
}

LeftEdits Autosave::found_edits() const {
  const fs::path origin = origin_of(found_->path());
  const fs::path folder = origin.empty() ? fs::current_path() : origin.parent_path();
  return {with_paths_from(read_scene(found_->path() / kScene), folder), origin};
}

void Autosave::adopt_found() {
  remove();
  own_file_ = origin_of(found_->path());
  own_ = std::exchange(found_, std::nullopt);
}

void Autosave::remove_found() {
  if (found_) remove_copy(*found_, states_);
  found_.reset();
}

fs::path state_folder() {
  if (const char* states = std::getenv("XDG_STATE_HOME"); states && *states) return fs::path(states) / "griffith";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".local/state/griffith";
  return {};
}

}  // namespace griffith::app
