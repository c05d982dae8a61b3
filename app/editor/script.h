#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene_setting.h"
#include "ui/model/commands.h"
#include "ui/model/shortcut.h"

namespace griffith::app {

/// What a line of a script does.
enum class Verb {
  command,
  set,
  projectile,
  choose,
  look,
  click,
  drag,
  scroll,
  type,
  key,
  step,
  wait,
  expect,
  say,
  screenshot
};

/// A line of a script that has been checked. Of the last members those are used that the verb needs.
struct ScriptLine {
  std::string place;  ///< "tour.script:12", for errors
  Verb verb = Verb::wait;
  std::string tag;            ///< click, drag, scroll, expect, say: of a widget
  std::string text;           ///< type, expect, say: what is typed, shown or said; screenshot: the file
  bool any_value = false;     ///< expect: the widget is there, whatever it shows
  int button = 0;             ///< click: of the mouse
  int count = 0;              ///< step: time steps; wait: frames
  float right = 0, down = 0;  ///< drag [pixels]; scroll: the second, in notches
  ui::Shortcut key;
  ui::Command command = {};
  std::vector<SceneSetting> settings = {};         ///< set, projectile: fields and their values
  std::vector<std::string> names = {};             ///< choose: of entries
  Vec3 eye = Vec3::Zero(), target = Vec3::Zero();  ///< look [m]
};

/// What can be done in the editor, line by line: a tour, a test, a bug report. docs/scripts.md describes the verbs.
using Script = std::vector<ScriptLine>;

/// Reads a script. `name`: of its file, for errors. Throws InputError that names the line.
Script parse_script(std::string_view text, const std::string& name);
/// Reads a script's file. Throws InputError.
Script read_script(const std::filesystem::path& file);

/// The tour of the help menu.
Script tour();

/// The text as a word of a script, in quotes where need be.
std::string script_word(const std::string& text);

/// The line of a script that has this done, without its end: "command file.open_path scenes/arch.json".
std::string script_line(const ui::Command& command);

}  // namespace griffith::app
