#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace griffith {

/// A value that takes the place of one in a scene file, before the file is read.
struct SceneSetting {
  std::string pointer;  ///< RFC 6901: "/bodies/0/material/young_modulus"
  std::string value;    ///< JSON text: "1e9", "\"glass\"", "[0, -9.81, 0]"
  bool operator==(const SceneSetting&) const = default;
};

/// The JSON pointer in a text such as "bodies/0/position/1", whose first slash may be missing or follow a "#". Throws
/// InputError, which names `where`, when the text is no pointer.
std::string scene_pointer(const std::string& text, const std::string& where);

/// The JSON text that a user's word stands for: the word where it is JSON, else a string of it (glass, "glass").
std::string setting_value(const std::string& word);

/// The word that setting_value() makes `value` of.
std::string setting_word(const std::string& value);

/// The setting in "POINTER=VALUE". Throws InputError, which names `where`, for a text of another form.
SceneSetting read_setting(const std::string& text, const std::string& where);

/// The JSON text of what a scene file with these settings says at `pointer`, or means where it leaves that out. Throws
/// InputError where the scene has no such field, and where the file cannot be read.
std::string scene_value(const std::filesystem::path& scene_file, const std::string& pointer,
                        std::span<const SceneSetting> settings = {});

/// Whether a setting of `later` leaves nothing of one of `earlier` that came before it: the same field, or one that it
/// is part of.
inline bool hides(const std::string& later, const std::string& earlier) {
  return earlier == later || earlier.starts_with(later + "/");
}

}  // namespace griffith
