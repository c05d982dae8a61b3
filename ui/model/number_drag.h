#pragma once

#include "sim/scene/field.h"

namespace griffith::ui {

/// Number at the start of a drag.
struct DragStart {
  double value = 0;             ///< value within `numbers`
  Numbers numbers;              ///< numbers that the field accepts
  bool whole = false;           ///< accepts only integers
  double vector_magnitude = 0;  ///< magnitude of the largest component of its vector
  double usual = 0;             ///< magnitude that a drag from 0 reaches in 200 pixels; 0: that of the unit
};

/// Modifiers of a drag.
struct DragPace {
  bool fine = false;    ///< Shift: a tenth of the change per pixel
  bool coarse = false;  ///< Ctrl: ten times the change, in steps of 1, 2 or 5 times a power of ten

  double factor() const { return (fine ? 0.1 : 1) * (coarse ? 10 : 1); }
};

/// Returns the dragged number. Positive numbers that span several magnitudes grow by 0.5 % a pixel. Others change by
/// 0.5 % of their start value a pixel, ratios by 0.5 % of the smaller of 1 and their range, angles by half a degree,
/// and counts by at least 0.1. The result has no more digits than these steps need and lies within the field's limits.
/// `moved`: pixels to the right, each times the pace's factor; 0 returns the start value itself.
double dragged_number(const DragStart& start, double moved, const DragPace& pace = {});

}  // namespace griffith::ui
