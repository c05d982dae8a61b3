#include "app/editor/script.h"

#include <app/editor/tour.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <optional>
#include <sstream>

#include "app/editor/editor_commands.h"
#include "sim/core/error.h"
#include "sim/core/file_content.h"

namespace griffith::app {
namespace {

constexpr int kMaxCount = 1'000'000;

/// Reads the words of a line one by one.
class Words {
 public:
  /// Splits `line` at blanks; a text in "quotes" is one word. A # begins a comment.
  Words(std::string_view line, std::string place) : place_(std::move(place)) {
    for (std::size_t i = 0; i < line.size();) {
      if (line[i] == '#') break;
      if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
        ++i;
      } else if (line[i] == '"') {
        words_.push_back(quoted(line, i));
      } else {
        const std::size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
        words_.emplace_back(line.substr(i, end - i));
        i = end;
      }
    }
  }

  bool empty() const { return next_ >= words_.size(); }
  std::size_t left() const { return words_.size() - next_; }
  const std::string& place() const { return place_; }

  /// Returns the next word. `meaning`: its expected meaning, as "a tag".
  std::string take(const std::string& meaning) {
    if (empty()) fail("lacks " + meaning, "add it at the end of the line");
    return words_[next_++];
  }

  template <typename Number>
  Number take_number(const std::string& meaning, Number least, Number most) {
    const std::string word = take(meaning);
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !(value >= least && value <= most)) {
      std::ostringstream range;
      range << "write a number from " << least << " to " << most;
      fail("has \"" + word + "\" as " + meaning, range.str());
    }
    return value;
  }

  void end() const {
    if (!empty()) fail("has \"" + words_[next_] + "\" at its end, which is not expected", "put text in \"quotes\"");
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw InputError(place_, problem, remedy);
  }

 private:
  /// Returns the text from the quote at `i` to its end; `i` moves past it.
  std::string quoted(std::string_view line, std::size_t& i) const {
    std::string text;
    for (++i; i < line.size() && line[i] != '"'; ++i) {
      if (line[i] == '\\' && i + 1 < line.size()) ++i;
      text += line[i];
    }
    if (i >= line.size()) fail("has an unterminated quote", "close it with \"");
    ++i;
    return text;
  }

  std::string place_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

constexpr float kMaxDrag = 1e5f;
constexpr double kFarthest = 1e6;  // [m]

void read_argument(Words& words, ui::CommandArgument argument, ui::Command& command) {
  switch (argument) {
    case ui::CommandArgument::none:
      return;
    case ui::CommandArgument::path:
      command.path = words.take("a file");
      return;
    case ui::CommandArgument::branch_and_step:
      command.branch = words.take_number("the branch", 0, kMaxCount);
      [[fallthrough]];
    case ui::CommandArgument::step:
      command.step = words.take_number<std::int64_t>("the step", 0, kMaxCount);
      return;
    case ui::CommandArgument::cursor:
      command.cursor.x() = words.take_number("the horizontal position in the view", 0.0, 1.0);
      command.cursor.y() = words.take_number("the vertical position in the view", 0.0, 1.0);
      return;
    case ui::CommandArgument::array:
      command.step = words.take_number<std::int64_t>("the number of bodies", 2, ui::kMaxArray);
      for (double& way : command.offset) way = words.take_number("the offset [m]", -kFarthest, kFarthest);
  }
}

void read_command(Words& words, ScriptLine& line) {
  const std::string name = words.take("a command");
  const ui::CommandInfo* info = ui::find_command(command_registry(), name);
  if (!info) words.fail("names no command: \"" + name + "\"", "see the palette (Ctrl+P) or docs/scripts.md");
  line.command.name = info->name;
  const bool needed = info->menu == ui::Menu::none && info->with_path.empty();  // the others ask for a missing argument
  if (!needed && words.empty()) return;
  if (info->argument == ui::CommandArgument::none && !words.empty())
    words.fail("has \"" + words.take("") + "\" after " + name + ", which takes no argument", "leave it out");
  if (!info->with_path.empty()) line.command.name = info->with_path;
  read_argument(words, info->argument, line.command);
}

/// Reads pairs of a pointer, prefixed with `before`, and a value.
void read_settings(Words& words, ScriptLine& line, const std::string& before) {
  do {
    const std::string pointer = scene_pointer(words.take("a field"), words.place());
    line.settings.push_back({before + pointer, setting_value(words.take("a value"))});
  } while (!words.empty());
}

void read_set(Words& words, ScriptLine& line) { read_settings(words, line, ""); }
void read_projectile(Words& words, ScriptLine& line) { read_settings(words, line, "/projectiles/0"); }

void read_choose(Words& words, ScriptLine& line) {
  do line.names.push_back(words.take("the name of a part of the scene"));
  while (!words.empty());
}

void read_look(Words& words, ScriptLine& line) {
  for (Vec3* place : {&line.eye, &line.target})
    for (double& coordinate : *place) coordinate = words.take_number("a coordinate", -kFarthest, kFarthest);
  if (line.eye == line.target) words.fail("has the eye at the target", "move the eye away from the target");
}

void read_click(Words& words, ScriptLine& line) {
  line.tag = words.take("the tag of a widget");
  if (words.empty()) return;
  constexpr std::array<std::string_view, 3> kButtons = {"left", "right", "middle"};
  const std::string button = words.take("a button");
  const auto found = std::ranges::find(kButtons, button);
  if (found == kButtons.end()) words.fail("has no mouse button \"" + button + "\"", "write left, right or middle");
  line.button = static_cast<int>(found - kButtons.begin());
}

void read_drag(Words& words, ScriptLine& line) {
  line.tag = words.take("the tag of a widget");
  line.right = words.take_number("the distance to the right", -kMaxDrag, kMaxDrag);
  line.down = words.take_number("the distance down", -kMaxDrag, kMaxDrag);
}

void read_scroll(Words& words, ScriptLine& line) {
  line.tag = words.take("the tag of a widget");
  line.down = words.take_number("the notches down", -kMaxDrag, kMaxDrag);
}

void read_type(Words& words, ScriptLine& line) {
  if (words.left() > 1) line.tag = words.take("the tag of a widget");
  line.text = words.take("a text");
}

void read_key(Words& words, ScriptLine& line) {
  const std::string name = words.take("a key");
  const std::optional<ui::Shortcut> key = ui::shortcut_from_text(name);
  if (!key) words.fail("is not a key: \"" + name + "\"", "write it as Ctrl+Shift+Z, Space, F1 or Enter");
  line.key = *key;
}

void read_count(Words& words, ScriptLine& line) {
  line.count = words.empty() ? 1 : words.take_number("a number", 1, kMaxCount);
}

void read_expect(Words& words, ScriptLine& line) {
  line.tag = words.take("the tag of a widget");
  line.any_value = words.empty();
  if (!line.any_value) line.text = words.take("a text");
}

void read_say(Words& words, ScriptLine& line) {
  if (words.left() > 1) line.tag = words.take("the tag of a widget");
  line.text = words.take("a text");
}

void read_file_name(Words& words, ScriptLine& line) {
  line.text = words.take("a file");
  if (std::filesystem::path(line.text).extension() != ".png")
    words.fail("has \"" + line.text + "\", not the name of a PNG file", "use the extension .png");
}

struct VerbInfo {
  std::string_view name;
  void (*read)(Words& words, ScriptLine& line);
};

/// By Verb.
constexpr std::array<VerbInfo, 15> kVerbs = {{{"command", read_command},
                                              {"set", read_set},
                                              {"projectile", read_projectile},
                                              {"choose", read_choose},
                                              {"look", read_look},
                                              {"click", read_click},
                                              {"drag", read_drag},
                                              {"scroll", read_scroll},
                                              {"type", read_type},
                                              {"key", read_key},
                                              {"step", read_count},
                                              {"wait", read_count},
                                              {"expect", read_expect},
                                              {"say", read_say},
                                              {"screenshot", read_file_name}}};

ScriptLine parse_line(Words words) {
  const std::string verb = words.take("a verb");
  const auto found = std::ranges::find(kVerbs, verb, &VerbInfo::name);
  if (found == kVerbs.end()) {
    std::string names;
    for (const VerbInfo& info : kVerbs) names.append(names.empty() ? "" : ", ").append(info.name);
    words.fail("begins with \"" + verb + "\", which is not a verb", "the verbs are " + names);
  }
  ScriptLine line;
  line.place = words.place();
  line.verb = static_cast<Verb>(found - kVerbs.begin());
  found->read(words, line);
  words.end();
  return line;
}

}  // namespace

Script parse_script(std::string_view text, const std::string& name) {
  Script script;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    Words words(line, name + ":" + std::to_string(++number));
    if (!words.empty()) script.push_back(parse_line(std::move(words)));
  }
  return script;
}

Script read_script(const std::filesystem::path& file) { return parse_script(read_expected_file(file), file.string()); }

Script tour() { return parse_script(tour_script, "tour"); }

std::string script_word(const std::string& text) {
  if (!text.empty() && text.find_first_of(" \t\"#\\") == std::string::npos) return text;
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "\"";
}

std::string script_line(const ui::Command& command) {
  const ui::CommandInfo& info = command_info(command.name);
  std::ostringstream line;
  line << "command " << info.name;
  switch (info.argument) {
    case ui::CommandArgument::none:
      break;
    case ui::CommandArgument::path:
      // With the file for which its dialog would ask, a command needs no dialog.
      if (!command.path.empty() && info.with_path.empty()) line << " " << script_word(command.path.string());
      break;
    case ui::CommandArgument::step:
      line << " " << command.step;
      break;
    case ui::CommandArgument::branch_and_step:
      line << " " << command.branch << " " << command.step;
      break;
    case ui::CommandArgument::cursor:
      line << " " << command.cursor.x() << " " << command.cursor.y();
      break;
    case ui::CommandArgument::array:
      if (!info.with_path.empty()) break;  // its dialog asks
      line << " " << command.step;
      for (const double way : command.offset) line << " " << way;
  }
  return line.str();
}

}  // namespace griffith::app
