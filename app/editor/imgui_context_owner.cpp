#include "app/editor/imgui_context_owner.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "ui/model/input_queue.h"
#include "ui/widgets/style.h"

namespace griffith::app {

ImGuiContextOwner::ImGuiContextOwner(float scale) : context_(ImGui::CreateContext()), scale_(scale) {
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  ui::map_keys(ImGui::GetIO());
  ui::apply_style(scale);
  fonts_ = ui::load_fonts(scale);
  ImGui_ImplOpenGL3_Init("#version 330");
}

ImGuiContextOwner::~ImGuiContextOwner() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

bool ImGuiContextOwner::set_scale(float scale) {
  if (scale == scale_) return false;
  scale_ = scale;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui::GetIO().Fonts->Clear();
  ui::apply_style(scale);
  fonts_ = ui::load_fonts(scale);
  ImGui_ImplOpenGL3_CreateFontsTexture();
  return true;
}

void ImGuiContextOwner::begin_frame(int width, int height) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = 1.0f / 60;
  begin_frame();
}

void ImGuiContextOwner::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void ImGuiContextOwner::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void ImGuiContextOwner::end_frame(ImVec2 corner, ImVec2 size) {
  ImGui::Render();
  ImDrawData* data = ImGui::GetDrawData();
  data->DisplayPos = corner;
  data->DisplaySize = size;
  ImGui_ImplOpenGL3_RenderDrawData(data);
}

}  // namespace griffith::app
