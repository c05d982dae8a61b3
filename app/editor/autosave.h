#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/descriptor.h"
#include "sim/scene/scene.h"

namespace griffith::app {

/// A folder that is locked while this program holds it: others can tell whether it is still in use, even after a crash.
/// It stays when the lock is released.
class LockedFolder {
 public:
  /// A new one whose path is `prefix` and six more characters. Throws InputError when it cannot be made.
  static LockedFolder make(const std::filesystem::path& prefix);
  /// One that is there, nothing when it is another user's or somebody holds it.
  static std::optional<LockedFolder> take(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }

 private:
  LockedFolder(std::filesystem::path path, Descriptor lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  Descriptor lock_;
};

/// Edits that were never saved, since the program was cut short.
struct LeftEdits {
  Scene scene;
  std::filesystem::path file;  ///< of the scene that was edited; empty when it had none yet
};

/// Keeps a copy of edits that are not saved: for a scene with a file in the folder `.NAME.edits-XXXXXX` beside it, for
/// others in the user's folder for states. Instances of the program know their copies apart by locks, and leave those
/// of others that run alone. What stands beside a scene may come from elsewhere with it: links there are not followed,
/// the name of a copy alone tells whose it is, and nothing is removed but what the program wrote.
class Autosave {
 public:
  /// `states`: the user's folder for states; also holds links to all copies beside scenes. Empty: there is none.
  explicit Autosave(std::filesystem::path states) : states_(std::move(states)) {}

  /// Writes a copy of the scene, whose file is `file` (absolute, or empty), in place of the last one. Throws InputError
  /// when that fails.
  void write(const Scene& scene, const std::filesystem::path& file);
  /// Removes the copy, if there is one: the edits are saved, or not wanted.
  void remove();

  /// Finds the newest copy that nobody holds, of the scene in `file` (absolute, or empty), and holds it.
  bool find(const std::filesystem::path& file);
  /// Looks among those of all scenes that the user's folder for states knows.
  bool find_any(const std::filesystem::path& file);
  bool has_found() const { return found_.has_value(); }
  /// Name of the copy that was found: "wall.json, 22 November 05:13".
  std::string found_text() const;
  /// What it holds. Throws InputError when it cannot be read.
  LeftEdits found_edits() const;
  /// Makes it this program's own.
  void adopt_found();
  void remove_found();
  /// Leaves it for the next start.
  void leave_found() { found_.reset(); }

 private:
  void begin_copy(const std::filesystem::path& file);
  bool take_newest(std::vector<std::filesystem::path> copies);

  std::filesystem::path states_;
  std::optional<LockedFolder> own_, found_;
  std::filesystem::path own_file_;  ///< whose copy `own_` is
};

/// $XDG_STATE_HOME/griffith, or ~/.local/state/griffith; empty when neither variable is set.
std::filesystem::path state_folder();

}  // namespace griffith::app
