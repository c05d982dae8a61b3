#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace griffith {

/// Value that replaces one in a scene file before the file is read.
struct SceneSetting {
  std::string pointer;  ///< RFC 6901: "/bodies/0/material/young_modulus"
  std::string value;    ///< JSON text: "1e9", "\"glass\"", "[0, -9.81, 0]"
  bool operator==(const SceneSetting&) const = default;
};

/// Returns the JSON pointer in a text such as "bodies/0/position/1", whose first slash may be missing or follow a "#".
/// Throws InputError, which names `where`, if the text is not a pointer.
std::string scene_pointer(const std::string& text, const std::string& where);

/// Returns the JSON text of a user's word: the word itself if it is JSON, a number written otherwise (.5, +5), else a
/// string of it (glass, "glass").
std::string setting_value(const std::string& word);

/// Returns the word that setting_value() turns into `value`.
std::string setting_word(const std::string& value);

/// Returns the setting in "POINTER=VALUE". Throws InputError, which names `where`, for any other form.
SceneSetting read_setting(const std::string& text, const std::string& where);

/// Returns the JSON text of the value at `pointer` in a scene file with these settings, including defaults. Throws
/// InputError if the scene has no such field, or the file cannot be read.
std::string scene_value(const std::filesystem::path& scene_file, const std::string& pointer,
                        std::span<const SceneSetting> settings = {});

/// True if a setting of `later` completely replaces an earlier one of `earlier`: the same field, or one that contains
/// it.
inline bool hides(const std::string& later, const std::string& earlier) {
  return earlier == later || earlier.starts_with(later + "/");
}

}  // namespace griffith
