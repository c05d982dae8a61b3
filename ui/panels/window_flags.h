#pragma once

#include <imgui.h>

namespace griffith::ui {

/// Flags of the editor's windows, whose places are those of its layout.
inline constexpr ImGuiWindowFlags kFixedWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                                 ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace griffith::ui
