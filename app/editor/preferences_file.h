#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/model/preferences.h"

namespace griffith::app {

/// File with a user's preferences.
class PreferencesFile {
 public:
  /// `file`: empty to keep nothing.
  explicit PreferencesFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Returns the preferences in the file; the defaults if there is none. Throws InputError if it cannot be parsed.
  ui::Preferences read();
  /// Writes preferences that differ from those last read or written. Throws InputError, once for each change.
  void keep(const ui::Preferences& preferences);

 private:
  std::filesystem::path file_;
  ui::Preferences kept_;
};

/// Returns $XDG_CONFIG_HOME/griffith/preferences.json, or the file in ~/.config; empty if neither variable is set.
std::filesystem::path preferences_path();

}  // namespace griffith::app
