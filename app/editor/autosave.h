#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/descriptor.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// A folder that is locked while this program holds it, so that others know whether it is in use, even after a crash.
/// It stays when the lock is released.
class LockedFolder {
 public:
  /// Makes a folder whose path is `prefix` and six more characters. Throws InputError if it cannot be made.
  static LockedFolder make(const std::filesystem::path& prefix);
  /// Locks an existing folder; empty if it belongs to another user or is locked.
  static std::optional<LockedFolder> take(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }

 private:
  LockedFolder(std::filesystem::path path, Descriptor lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  Descriptor lock_;
};

/// Unsaved edits of a crashed run.
struct UnsavedEdits {
  Scene scene;
  std::filesystem::path file;  ///< file of the edited scene; empty if it had none yet
};

/// Keeps a copy of unsaved edits: in the folder `.NAME.edits-XXXXXX` next to the scene's file, or in the user's state
/// folder for a scene without a file. Locks separate the copies of running instances. A folder may come from elsewhere
/// together with a scene. Links in it are therefore not followed, the name of a copy alone determines its scene, and
/// only files of this program are removed.
class Autosave {
 public:
  /// `states`: the user's state folder, which also holds links to all copies next to scenes. Empty: there is none.
  explicit Autosave(std::filesystem::path states) : states_(std::move(states)) {}

  /// Replaces the copy of the scene with the file `file` (absolute, or empty). Throws InputError if that fails.
  void write(const Scene& scene, const std::filesystem::path& file);
  /// Removes the copy, if there is one, after the edits were saved or discarded.
  void remove();

  /// Finds and locks the newest free copy of the scene in `file` (absolute, or empty).
  bool find(const std::filesystem::path& file);
  /// Finds and locks the newest free copy of any scene known in the user's state folder.
  bool find_any(const std::filesystem::path& file);
  bool has_found() const { return found_.has_value(); }
  /// Describes the found copy: "wall.json, 22 November 05:13".
  std::string found_text() const;
  /// Reads the found copy. Throws InputError if that fails.
  UnsavedEdits found_edits() const;
  /// Makes the found copy this program's own.
  void adopt_found();
  void remove_found();
  /// Leaves the found copy for the next start.
  void leave_found() { found_.reset(); }

 private:
  void begin_copy(const std::filesystem::path& file);
  bool take_newest(std::vector<std::filesystem::path> copies);

  std::filesystem::path states_;
  std::optional<LockedFolder> own_, found_;
  std::filesystem::path own_file_;  ///< file of the scene copied in `own_`
};

/// Returns $XDG_STATE_HOME/griffith, or ~/.local/state/griffith; empty if neither variable is set.
std::filesystem::path state_folder();

}  // namespace griffith::app
