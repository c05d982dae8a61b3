#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/model/run_curves.h"

namespace griffith::ui {

/// With what the shown branch is compared, and how.
struct Comparison {
  std::optional<int> branch;  ///< none: nothing is compared
  bool as_ghost = false;      ///< one picture through the other; else side by side, parted by a border
  float border = 0.5f;        ///< 0..1 of the view's width: the shown branch is left of it
};

/// What the compared branch shows at the same step.
struct ComparisonView {
  int branch = 0;
  ImTextureID picture = {};
  std::string text;  ///< where and when the two differ first, and how far they are apart now
  RunCurves curves;  ///< those that are plotted, while plots are shown
};

}  // namespace griffith::ui
