#include "app/editor/macro_recorder.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "app/editor/editor_commands.h"
#include "app/editor/script.h"
#include "sim/scene/scene_difference.h"

namespace griffith::app {
namespace {

/// Running is recorded as steps, a macro within a macro as its lines, a dialog as the command that it issues.
bool is_recorded(const ui::CommandInfo& info) { return info.recorded && !info.label.ends_with("…"); }

std::string settings_line(const char* verb, const std::vector<SceneSetting>& settings, std::size_t prefix) {
  std::string line = verb;
  for (const SceneSetting& setting : settings)
    line += " " + script_word(setting.pointer.substr(prefix)) + " " + script_word(setting_word(setting.value));
  return line;
}

std::string look_line(const render::Camera& camera) {
  std::ostringstream line;
  line << "look";
  for (const Eigen::Vector3f& place : {camera.position, camera.target})
    for (const float coordinate : place) line << " " << coordinate;
  return line.str();
}

bool same_view(const render::Camera& a, const render::Camera& b) {
  return a.position == b.position && a.target == b.target;
}

}  // namespace

Scene scene_of_shot(const ProjectileBurst& shot) {
  Scene scene;
  scene.projectiles = {shot};
  return scene;
}

void MacroRecorder::note(const MacroMoment& now) {
  waiting_steps_ += std::max<std::int64_t>(0, now.step - last_.step);
  camera_moved_ |= !same_view(now.camera, last_.camera);
  const MacroMoment before = std::exchange(last_, now);
  if (!(before.scene == now.scene)) {
    constexpr std::size_t kSlash = 1;
    const std::vector<SceneSetting> settings = settings_between(before.scene, now.scene);
    if (!settings.empty()) add_line(settings_line("set", settings, kSlash));
  }
  if (!(before.shot == now.shot)) {
    const std::size_t list = std::string("/projectiles/0/").size();
    const std::vector<SceneSetting> settings = settings_between(scene_of_shot(before.shot), scene_of_shot(now.shot));
    if (!settings.empty()) add_line(settings_line("projectile", settings, list));
  }
  if (before.chosen != now.chosen && !now.chosen.empty()) {
    std::string line = "choose";
    for (const std::string& name : now.chosen) line += " " + script_word(name);
    add_line(line);
  }
}

void MacroRecorder::add(const ui::Command& command, MacroMoment now) {
  if (!is_recorded(command_info(command.name))) return;
  last_ = std::move(now);
  const std::string line = script_line(command);
  const bool drags = command.name == "time.step" || command.name == "simulation.drag_to";
  const bool drags_on = drags && !lines_.empty() && waiting_steps_ == 0 &&
                        lines_.back().starts_with("command " + std::string(command.name) + " ");
  if (drags_on) lines_.pop_back();
  add_line(line);
}

std::string MacroRecorder::text(const MacroMoment& end) {
  note(end);
  add_waiting();
  std::string text = "# Recorded in the editor; docs/scripts.md describes the verbs.\n";
  for (const std::string& line : lines_) text += line + "\n";
  return text;
}

void MacroRecorder::add_line(std::string line) {
  add_waiting();
  lines_.push_back(std::move(line));
}

void MacroRecorder::add_waiting() {
  if (waiting_steps_ > 0) lines_.push_back("step " + std::to_string(std::exchange(waiting_steps_, 0)));
  if (std::exchange(camera_moved_, false)) lines_.push_back(look_line(last_.camera));
}

}  // namespace griffith::app
