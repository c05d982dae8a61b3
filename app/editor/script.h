#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene_setting.h"
#include "ui/model/commands.h"
#include "ui/model/shortcut.h"

namespace griffith::app {

/// Action of a line of a script.
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

/// A checked line of a script. Only the members of its verb are used.
struct ScriptLine {
  std::string place;  ///< "tour.script:12", for errors
  Verb verb = Verb::wait;
  std::string tag;            ///< click, drag, scroll, expect, say: tag of a widget
  std::string text;           ///< type, expect, say: typed, expected or shown text; screenshot: the file
  bool any_value = false;     ///< expect: the widget exists, with any value
  int button = 0;             ///< click: button of the mouse
  int count = 0;              ///< step: time steps; wait: frames
  float right = 0, down = 0;  ///< drag: displacement [pixels]; scroll: `down` in notches
  ui::Shortcut key;
  ui::Command command = {};
  std::vector<SceneSetting> settings = {};         ///< set, projectile: fields with their values
  std::vector<std::string> names = {};             ///< choose: names of entries to select
  Vec3 eye = Vec3::Zero(), target = Vec3::Zero();  ///< look [m]
};

/// Actions in the editor, line by line: a tour, a test, a bug report. docs/scripts.md describes the verbs.
using Script = std::vector<ScriptLine>;

/// Parses a script. `name`: of its file, for errors. Throws InputError that names the line.
Script parse_script(std::string_view text, const std::string& name);
/// Reads a script file. Throws InputError.
Script read_script(const std::filesystem::path& file);

/// Returns the tour of the help menu.
Script tour();

/// Returns the text as a word of a script, quoted if necessary.
std::string script_word(const std::string& text);

/// Returns the line of a script that issues the command, without a line break: "command file.open_path
/// scenes/arch.json".
std::string script_line(const ui::Command& command);

}  // namespace griffith::app
