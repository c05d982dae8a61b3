#pragma once

#include <imgui.h>

namespace griffith::ui {

/// Colors of the program.
namespace palette {
inline constexpr ImU32 kText = IM_COL32(226, 230, 235, 255);
inline constexpr ImU32 kTextDim = IM_COL32(140, 149, 160, 255);
inline constexpr ImU32 kWindow = IM_COL32(24, 27, 32, 255);
inline constexpr ImU32 kPanel = IM_COL32(30, 34, 40, 255);
inline constexpr ImU32 kField = IM_COL32(42, 48, 56, 255);
inline constexpr ImU32 kFieldHovered = IM_COL32(53, 60, 70, 255);
inline constexpr ImU32 kFieldActive = IM_COL32(64, 73, 85, 255);
inline constexpr ImU32 kLine = IM_COL32(52, 58, 67, 255);
inline constexpr ImU32 kAccent = IM_COL32(232, 145, 58, 255);
inline constexpr ImU32 kAccentDim = IM_COL32(232, 145, 58, 90);
inline constexpr ImU32 kGood = IM_COL32(104, 190, 130, 255);
inline constexpr ImU32 kWarning = IM_COL32(240, 196, 83, 255);
inline constexpr ImU32 kError = IM_COL32(235, 99, 92, 255);
}  // namespace palette

/// Converts a color to the type of style entries.
ImVec4 as_vec4(ImU32 color);

/// Applies the program's style to the current ImGui context. `scale`: screen pixels per design pixel.
void apply_style(float scale);

}  // namespace griffith::ui
