#include "app/editor/script_player.h"

#include <imgui.h>

#include <utility>

#include "sim/core/error.h"
#include "ui/model/gestures.h"

namespace griffith::app {
namespace {

/// Least number of frames for a line: dialogs need some to find their place.
constexpr int kFramesToSettle = 4;

ui::WidgetTag widget(const ScriptLine& line, const Editor& editor) {
  const ui::WidgetTag* found = ui::find_tag(editor.tags(), line.tag);
  if (!found)
    throw InputError(line.place, "there is no widget \"" + line.tag + "\" visible",
                     "open the menu, list or section that contains it");
  return *found;
}

/// Returns the point of a widget that the mouse uses.
ImVec2 place_on(const ScriptLine& line, const Editor& editor) {
  const ImVec2 place = widget(line, editor).center(), size = ImGui::GetIO().DisplaySize;
  if (place.x < 0 || place.y < 0 || place.x >= size.x || place.y >= size.y)
    throw InputError(line.place, "the widget \"" + line.tag + "\" is not in the window",
                     "scroll to it, fold sections above it, or use a larger window");
  return place;
}

void expect(const ScriptLine& line, const Editor& editor) {
  const ui::WidgetTag shown = widget(line, editor);
  if (!line.any_value && shown.value != line.text)
    throw InputError(line.place, line.tag + " shows \"" + shown.value + "\" instead of \"" + line.text + "\"", "");
}

void carry_out(const ScriptLine& line, Editor& editor) {
  const std::string_view reason = editor.disabled_reason(line.command.name);
  if (!reason.empty())
    throw InputError(line.place, std::string(line.command.name) + " is disabled", std::string(reason));
  editor.execute(line.command);
}

}  // namespace

void ScriptPlayer::advance(Editor& editor, ui::InputQueue& input) {
  if (!input.empty() || ui::is_busy(editor.state()) || waits_for_reader(editor)) return;
  if (frames_left_ > 0 && --frames_left_ > 0) return;
  if (next_ >= script_.size()) return;
  const ScriptLine line = script_[next_++];
  frames_left_ = kFramesToSettle;
  play(line, editor, input);
  if (const std::optional<Script> called = editor.scripting().take_request()) insert(*called, line.place);
}

void ScriptPlayer::insert(const Script& called, const std::string& place) {
  constexpr std::size_t kMostLines = 100'000;
  constexpr int kMostMacros = 1000;
  if (script_.size() + called.size() > kMostLines || ++macros_played_ > kMostMacros)
    throw InputError(place, "makes more than 100,000 lines or plays more than 1,000 macros",
                     "a macro must not play itself");
  script_.insert(script_.begin() + static_cast<std::ptrdiff_t>(next_), called.begin(), called.end());
}

bool ScriptPlayer::waits_for_reader(Editor& editor) {
  std::optional<ui::Caption>& caption = editor.state().caption;
  if (!caption || !for_reader_) return false;
  if (caption->answer == ui::Caption::Answer::none) return true;
  if (caption->answer == ui::Caption::Answer::skip) {
    next_ = script_.size();
    frames_left_ = 0;
  }
  caption.reset();
  return false;
}

void ScriptPlayer::play(const ScriptLine& line, Editor& editor, ui::InputQueue& input) {
  switch (line.verb) {
    case Verb::command:
      return carry_out(line, editor);
    case Verb::set:
      return set_values(editor.document().history(), editor.state(), line.settings, line.place);
    case Verb::projectile:
      return set_shot(editor.state(), line.settings, line.place);
    case Verb::choose:
      return app::choose(editor.state(), editor.document().scene(), line.names, line.place);
    case Verb::look:
      return editor.viewport().look_from(line.eye, line.target);
    case Verb::click:
      return ui::click(input, place_on(line, editor), line.button);
    case Verb::drag:
      return ui::drag(input, place_on(line, editor), {line.right, line.down});
    case Verb::scroll:
      return ui::scroll(input, place_on(line, editor), line.down);
    case Verb::type:
      if (!line.tag.empty()) ui::click(input, place_on(line, editor), 1);
      ui::type(input, line.text);
      return ui::press(input, {ui::key::kEnter});
    case Verb::key:
      return ui::press(input, line.key);
    case Verb::step:
      for (int i = 0; i < line.count; ++i) editor.run().step();
      return;
    case Verb::wait:
      frames_left_ = line.count;
      return;
    case Verb::expect:
      return expect(line, editor);
    case Verb::say:
      editor.state().caption = ui::Caption{line.text, line.tag};
      return;
    case Verb::screenshot:
      requested_picture_ = line.text;
  }
}

std::optional<std::filesystem::path> ScriptPlayer::take_picture_request() {
  return std::exchange(requested_picture_, std::nullopt);
}

}  // namespace griffith::app
