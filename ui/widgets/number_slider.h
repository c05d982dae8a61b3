#pragma once

#include <optional>
#include <string>

#include "ui/model/units.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

/// A physical quantity as an editable row.
struct NumberField {
  std::string tag;    ///< "material/young_modulus"
  std::string label;  ///< "Young's modulus"
  Numbers numbers;    ///< what a scene takes, in which unit
  std::string tooltip = {};
  double low = numbers.minimum, high = numbers.maximum;  ///< ends of the slider; beyond them values can be typed
  bool logarithmic = false;                              ///< equal distances are equal ratios; needs low > 0
  std::optional<double> original = {};  ///< a click on the label brings it back, which is bright while there is another
  std::optional<SiPrefix> prefix = {};  ///< of a row of several numbers, which says the unit once; none: its own
};

/// A slider with unit and SI prefix. Drag it, or right-click (Ctrl+click) to type a value: "20 GPa", "2e10 Pa", or a
/// bare number in the unit without prefix. While one types it says what that means; what is not taken as it was typed
/// leaves a note.
Edit number_slider(Panel& panel, const NumberField& field, double& value);

/// Draws it without label, and without an end in sight: dragging changes the value by a fraction of itself.
Edit number_drag(Panel& panel, const NumberField& field, double& value);

}  // namespace griffith::ui
