#include "ui_driver.h"

#include <gtest/gtest.h>

#include "ui/widgets/style.h"

namespace griffith::ui {
Scene two_walls() {
  Scene scene;
  scene.name = "two walls";
  for (const char* name : {"left", "right"}) {
    BodyDescription body;
    body.name = name;
    body.shape = BoxShape{};
    scene.bodies.push_back(body);
  }
  return scene;
}

Probe probe_of(const std::string& body, const std::string& name) {
  Probe probe;
  probe.body = body;
  probe.name = name;
  return probe;
}

UiDriver::UiDriver(Scene scene) : history(std::move(scene)) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {1500, 940};
  io.DeltaTime = 1.0f / 60;
  io.MousePos = {-1, -1};
  map_keys(io);
  apply_style(1);
  input.fonts = load_fonts(1);
  input.commands = app::command_registry();
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  for (int i = 0; i < 3; ++i) frame();
}

UiDriver::~UiDriver() { ImGui::DestroyContext(); }

void UiDriver::frame() {
  materials_.clear();
  for (const BodyDescription& body : history.scene().bodies) materials_.push_back(body.material);
  input.frame.materials = materials_;
  ImGui::NewFrame();
  for (Command& command : draw_editor(input, state, history, tags)) commands.push_back(std::move(command));
  ImGui::Render();
}

ImVec2 UiDriver::find(const std::string& tag) {
  const WidgetTag* found = find_tag(tags, tag);
  if (!found) ADD_FAILURE() << "no widget " << tag;
  return found ? found->center() : ImVec2(-1, -1);
}

std::string UiDriver::value(const std::string& tag) {
  const WidgetTag* found = find_tag(tags, tag);
  return found ? found->value : "no widget " + tag;
}

std::vector<std::string_view> UiDriver::issued() const {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

void UiDriver::play() {
  while (!queue.empty()) {
    queue.play(ImGui::GetIO());
    frame();
  }
}

void UiDriver::move(ImVec2 place) {
  queue.move(place);
  play();
}

void UiDriver::press(int button, bool down) {
  queue.button(button, down);
  play();
}

void UiDriver::click(const std::string& tag, int button) {
  ui::click(queue, find(tag), button);
  play();
  frame();
}

void UiDriver::drag(const std::string& tag, float dx, float dy, int button) {
  ui::drag(queue, find(tag), {dx, dy}, button);
  play();
  frame();
}

void UiDriver::type(const std::string& text) {
  ui::type(queue, text);
  ui::press(queue, {key::kEnter});
  play();
}

void UiDriver::press_key(int key, bool ctrl, bool shift, bool alt) {
  ui::press(queue, {key, ctrl, shift, alt});
  play();
}

}  // namespace griffith::ui
