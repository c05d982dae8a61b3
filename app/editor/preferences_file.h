#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/model/preferences.h"

namespace griffith::app {

/// The file that keeps a user's preferences from one start to the next.
class PreferencesFile {
 public:
  /// `file`: empty where nothing is to be kept.
  explicit PreferencesFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// What the file says; the usual where there is none. Throws InputError where it cannot be understood.
  ui::Preferences read();
  /// Writes them where they differ from what was read or written last. Throws InputError, once for each change.
  void keep(const ui::Preferences& preferences);

 private:
  std::filesystem::path file_;
  ui::Preferences kept_;
};

/// $XDG_CONFIG_HOME/griffith/preferences.json, or in ~/.config; empty when neither variable is set.
std::filesystem::path preferences_path();

}  // namespace griffith::app
