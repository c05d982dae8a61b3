#pragma once

#include "sim/scene/field.h"

namespace griffith::ui {

/// The number at which a drag begins.
struct DragStart {
  double value = 0;    ///< within `numbers`
  Numbers numbers;     ///< what its field takes
  bool whole = false;  ///< only integers
  double beside = 0;   ///< magnitude of the largest component of its vector
  double usual = 0;    ///< magnitude that a drag away from 0 reaches in 200 pixels; 0: that of the unit
};

/// Modifiers of a drag.
struct DragPace {
  bool fine = false;    ///< Shift: a tenth of the change a pixel
  bool coarse = false;  ///< Ctrl: ten times the change, to 1, 2 or 5 times a power of ten

  double factor() const { return (fine ? 0.1 : 1) * (coarse ? 10 : 1); }
};

/// The number to which a drag leads. Positive numbers of several magnitudes grow by 0.5 % a pixel. Others change by
/// 0.5 % a pixel of what they were, ratios by 0.5 % of the smaller of 1 and their range, angles by half a degree, and
/// counts by 0.1 at least. The result has no more digits than these steps need, and is within the field's limits.
/// `moved`: pixels to the right, each times the pace's factor; 0 gives the value at the start itself.
double dragged_number(const DragStart& start, double moved, const DragPace& pace = {});

}  // namespace griffith::ui
