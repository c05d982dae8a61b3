#include "app/interface.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "ui/style.h"

namespace griffith::app {

Interface::Interface(float scale) : context_(ImGui::CreateContext()) {
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  ui::apply_style(scale);
  fonts_ = ui::load_fonts(scale);
  ImGui_ImplOpenGL3_Init("#version 330");
}

Interface::~Interface() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Interface::begin_frame(int width, int height) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = 1.0f / 60;
  begin_frame();
}

void Interface::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Interface::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace griffith::app
