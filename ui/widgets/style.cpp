#include "ui/widgets/style.h"

#include <initializer_list>

namespace griffith::ui {
namespace {

void apply_colors(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  const auto set = [&style](ImGuiCol index, ImU32 color) { style.Colors[index] = as_vec4(color); };
  set(ImGuiCol_Text, palette::kText);
  set(ImGuiCol_TextDisabled, palette::kTextDim);
  for (ImGuiCol index :
       {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}) {
    set(index, palette::kPanel);
  }
  set(ImGuiCol_ChildBg, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_MenuBarBg, palette::kWindow);
  set(ImGuiCol_ScrollbarBg, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_Border, palette::kLine);
  set(ImGuiCol_Separator, palette::kLine);
  for (ImGuiCol index : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_ScrollbarGrab, ImGuiCol_Header}) {
    set(index, palette::kField);
  }
  for (ImGuiCol index : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_ScrollbarGrabHovered,
                         ImGuiCol_HeaderHovered, ImGuiCol_SeparatorHovered}) {
    set(index, palette::kFieldHovered);
  }
  for (ImGuiCol index :
       {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_ScrollbarGrabActive, ImGuiCol_HeaderActive}) {
    set(index, palette::kFieldActive);
  }
  for (ImGuiCol index : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_PlotHistogram,
                         ImGuiCol_SeparatorActive, ImGuiCol_ResizeGripActive}) {
    set(index, palette::kAccent);
  }
  set(ImGuiCol_ResizeGrip, IM_COL32_BLACK_TRANS);
  set(ImGuiCol_TextSelectedBg, palette::kAccentDim);
  set(ImGuiCol_ModalWindowDimBg, IM_COL32(10, 12, 15, 140));
}

}  // namespace

ImVec4 as_vec4(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

void apply_style(float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2};
  style.ScrollbarSize = 10;
  style.GrabMinSize = 10;
  style.WindowRounding = 0;
  style.ChildRounding = style.PopupRounding = 6;
  style.FrameRounding = style.GrabRounding = style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowMinSize = {32, 16};
  style.ScaleAllSizes(scale);
  apply_colors(style);
}

}  // namespace griffith::ui
