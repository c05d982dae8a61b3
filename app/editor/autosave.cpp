#include "app/editor/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <utility>
#include <vector>

#include "app/shared/scene_files.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

constexpr char kScene[] = "scene.json";
constexpr char kOldOrigin[] = "origin";  ///< written by earlier versions
constexpr std::string_view kMark = "edits-";
constexpr std::size_t kRandomLength = 6;

fs::path prefix_beside(const fs::path& file) {
  return fs::absolute(file).parent_path() / ("." + file.filename().string() + "." + std::string(kMark));
}

/// Returns the suffix "edits-XXXXXX" of the name of a copy; empty for any other name.
std::string_view mark_in(std::string_view name) {
  const std::size_t length = kMark.size() + kRandomLength;
  if (name.size() < length) return {};
  const std::string_view mark = name.substr(name.size() - length);
  const bool whole = mark.size() == name.size() || (name.starts_with('.') && name[name.size() - length - 1] == '.');
  const bool random = std::ranges::all_of(mark.substr(kMark.size()), [](unsigned char c) { return std::isalnum(c); });
  return whole && random && mark.starts_with(kMark) ? mark : std::string_view();
}

/// Returns the scene file of a copy, derived from the copy's own name because the content of a folder may come from
/// elsewhere. Empty if it had none.
fs::path origin_of(const fs::path& copy) {
  const std::string name = copy.filename().string();
  const std::size_t mark = mark_in(name).size();
  return mark == name.size() ? fs::path() : copy.parent_path() / name.substr(1, name.size() - mark - 2);
}

/// Returns the link in `states` to a copy next to a scene.
fs::path link_to(const fs::path& copy, const fs::path& states) { return states / mark_in(copy.filename().string()); }

/// True if it is a folder with the name and the scene of a copy, and none of these is a link.
bool is_copy(const fs::path& folder) {
  std::error_code ignored;
  return !mark_in(folder.filename().string()).empty() &&
         fs::symlink_status(folder, ignored).type() == fs::file_type::directory &&
         fs::symlink_status(folder / kScene, ignored).type() == fs::file_type::regular;
}

/// Removes the program's files, and the folder if it is then empty.
void remove_copy(const LockedFolder& copy, const fs::path& states) {
  std::error_code ignored;
  if (const fs::path link = link_to(copy.path(), states); fs::is_symlink(link, ignored)) fs::remove(link, ignored);
  for (const char* name : {kScene, kOldOrigin}) fs::remove(copy.path() / name, ignored);
  remove_stale_files(copy.path());
  fs::remove(copy.path(), ignored);
}

/// Adds the copies next to a scene. Links are not followed: the author of the scene may have put them there.
void collect_beside(const fs::path& file, std::vector<fs::path>& copies) {
  const fs::path scene = fs::absolute(file);
  for (const fs::path& path : files_in(scene.parent_path()))
    if (is_copy(path) && origin_of(path) == scene) copies.push_back(path);
}

/// Adds the copies in the user's state folder and those to which its links lead. Removes broken links, unless the
/// folder around the copy is missing too: its drive may not be mounted.
void collect_known(const fs::path& states, std::vector<fs::path>& copies) {
  std::error_code ignored;
  for (const fs::path& path : files_in(states)) {
    const std::string name = path.filename().string();
    if (mark_in(name) != name) continue;
    const bool is_link = fs::is_symlink(path, ignored);
    const fs::path copy = is_link ? fs::read_symlink(path, ignored) : path;
    if (is_copy(copy) && link_to(copy, states) == path) {
      copies.push_back(copy);
    } else if (is_link && fs::is_directory(copy.parent_path(), ignored)) {
      fs::remove(path, ignored);
    }
  }
}

fs::file_time_type time_of(const fs::path& copy) {
  std::error_code ignored;
  return fs::last_write_time(copy / kScene, ignored);
}

}  // namespace

LockedFolder LockedFolder::make(const fs::path& prefix) {
  std::string path = prefix.string() + "XXXXXX";
  if (mkdtemp(path.data())) {
    if (std::optional<LockedFolder> folder = take(path)) return std::move(*folder);
    rmdir(path.c_str());
  }
  throw InputError(prefix.parent_path().string(), "cannot hold a copy of the unsaved edits",
                   "save the scene in a writable folder");
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
  const bool is_new = !own_;
  if (is_new) begin_copy(file);
  try {
    write_scene(scene, own_->path() / kScene);
  } catch (const InputError&) {
    if (is_new) remove();  // leaves no empty folder
    throw;
  }
  // The link is made last: other instances remove links to copies without content.
  if (!file.empty() && !states_.empty())
    fs::create_directory_symlink(own_->path(), link_to(own_->path(), states_), ignored);
}

void Autosave::begin_copy(const fs::path& file) {
  if (file.empty() && states_.empty())
    throw InputError("the edits", "are not copied until the scene is saved",
                     "set HOME or XDG_STATE_HOME, or save the scene");
  std::error_code ignored;
  if (!states_.empty()) fs::create_directories(states_, ignored);
  own_ = LockedFolder::make(file.empty() ? states_ / kMark : prefix_beside(file));
  own_file_ = file;
}

void Autosave::remove() {
  if (own_) remove_copy(*own_, states_);
  own_.reset();
}

bool Autosave::find(const fs::path& file) {
  std::vector<fs::path> copies;
  if (!file.empty()) collect_beside(file, copies);
  return take_newest(std::move(copies));
}

bool Autosave::find_any(const fs::path& file) {
  std::vector<fs::path> copies;
  if (!states_.empty()) collect_known(states_, copies);
  if (!file.empty()) collect_beside(file, copies);
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

UnsavedEdits Autosave::found_edits() const {
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
