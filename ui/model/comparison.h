#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>

#include "ui/model/run_curves.h"

namespace griffith::ui {

/// Settings of the comparison with another branch.
struct Comparison {
  std::optional<int> branch;  ///< compared branch; none: no comparison
  std::int64_t step = 0;      ///< step of that branch in the picture
  bool as_ghost = false;      ///< overlays the pictures; else they are side by side, separated by a border
  float border = 0.5f;        ///< position of the border, 0..1 of the view's width; the shown branch is left of it
};

/// The compared branch at the shown step.
struct ComparisonView {
  int branch = 0;
  ImTextureID picture = {};
  std::string text;  ///< place and time of the first difference, and its size now
  RunCurves curves;  ///< plotted curves, while plots are shown
};

}  // namespace griffith::ui
